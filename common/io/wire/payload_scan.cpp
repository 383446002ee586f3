#include "common/io/wire/payload_scan.h"

#include <google/protobuf/descriptor.h>
#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/message.h>
#include <google/protobuf/wire_format_lite.h>

namespace accord {
namespace {

using google::protobuf::Descriptor;
using google::protobuf::FieldDescriptor;
using google::protobuf::internal::WireFormatLite;
using google::protobuf::io::CodedInputStream;

// How a field's values lie on the wire, as our encoders write them.
WireFormatLite::WireType expected_type(const FieldDescriptor& field) {
  if (field.is_packed()) return WireFormatLite::WIRETYPE_LENGTH_DELIMITED;
  return WireFormatLite::WireTypeForFieldType(static_cast<WireFormatLite::FieldType>(field.type()));
}

class Scanner {
 public:
  Scanner(CodedInputStream& in, std::size_t parts) : in_(in), parts_left_(parts) {}

  // Up to the stream's present limit.
  std::optional<std::string> scan(const Descriptor& message) {
    int last = 0;
    while (const std::uint32_t tag = in_.ReadTag()) {
      const int number = WireFormatLite::GetTagFieldNumber(tag);
      const FieldDescriptor* field = message.FindFieldByNumber(number);
      if (field == nullptr) {
        return message.name() + " has no field " + std::to_string(number) +
               " in this version of Accord";
      }
      if (WireFormatLite::GetTagWireType(tag) != expected_type(*field)) {
        return at(*field) + ": not a value of its type";
      }
      if (number < last || (number == last && (!field->is_repeated() || field->is_packed()))) {
        return at(*field) + ": out of order, or given twice";
      }
      last = number;
      if (auto fault = scan_value(*field)) return fault;
    }
    if (!in_.ConsumedEntireMessage()) return message.name() + ": cut short, or no message at all";
    return std::nullopt;
  }

 private:
  static std::string at(const FieldDescriptor& field) {
    return field.containing_type()->name() + "." + field.name();
  }

  std::optional<std::string> scan_value(const FieldDescriptor& field) {
    const std::string cut = at(field) + ": cut short";
    std::uint64_t number = 0;
    std::uint32_t size = 0;
    switch (expected_type(field)) {
      case WireFormatLite::WIRETYPE_VARINT:
        return in_.ReadVarint64(&number) ? std::nullopt : std::optional(cut);
      case WireFormatLite::WIRETYPE_FIXED64:
        return in_.Skip(8) ? std::nullopt : std::optional(cut);
      case WireFormatLite::WIRETYPE_LENGTH_DELIMITED:
        break;
      default:
        return at(field) + ": not a value of its type";
    }
    if (!in_.ReadVarint32(&size) || size > static_cast<std::uint32_t>(in_.BytesUntilLimit())) {
      return cut;
    }
    if (field.is_packed())
      return in_.Skip(static_cast<int>(size)) ? std::nullopt : std::optional(cut);
    if (parts_left_ == 0) return at(field) + ": more parts than any payload may have";
    --parts_left_;
    if (field.message_type() == nullptr) {
      return in_.Skip(static_cast<int>(size)) ? std::nullopt : std::optional(cut);
    }
    const auto outer = in_.PushLimit(static_cast<int>(size));
    auto fault = scan(*field.message_type());
    in_.PopLimit(outer);
    return fault;
  }

  CodedInputStream& in_;
  std::size_t parts_left_;
};

}  // namespace

std::optional<std::string> parse_payload(BytesView bytes, std::string_view what,
                                         const ScanLimits& limits, google::protobuf::Message& out) {
  const std::string subject(what);
  if (bytes.size() > limits.bytes) {
    return subject + " of " + std::to_string(bytes.size()) + " bytes; expected at most " +
           std::to_string(limits.bytes);
  }
  const int size = static_cast<int>(bytes.size());
  CodedInputStream in(bytes.data(), size);
  in.PushLimit(size);
  if (auto fault = Scanner(in, limits.parts).scan(*out.GetDescriptor())) return fault;
  if (!out.ParseFromArray(bytes.data(), size))
    return "not " + subject + ": Protobuf cannot read it";
  return std::nullopt;
}

Bytes serialize_payload(const google::protobuf::Message& message) {
  Bytes bytes(message.ByteSizeLong());
  google::protobuf::io::ArrayOutputStream stream(bytes.data(), static_cast<int>(bytes.size()));
  google::protobuf::io::CodedOutputStream out(&stream);
  out.SetSerializationDeterministic(true);
  message.SerializeWithCachedSizes(&out);
  return bytes;
}

}  // namespace accord
