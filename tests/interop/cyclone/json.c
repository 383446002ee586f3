#include "json.h"

void print_text(const char* text, FILE* out) {
  fputc('"', out);
  for (; *text != '\0'; ++text) {
    const unsigned char c = (unsigned char)*text;
    if (c < 0x20) {
      fprintf(out, "\\u%04x", c);
    } else {
      fprintf(out, c == '"' || c == '\\' ? "\\%c" : "%c", c);
    }
  }
  fputc('"', out);
}

void print_numbers(const double* numbers, uint32_t count, FILE* out) {
  fputc('[', out);
  for (uint32_t i = 0; i < count; ++i) fprintf(out, "%s%.17g", i == 0 ? "" : ", ", numbers[i]);
  fputc(']', out);
}
