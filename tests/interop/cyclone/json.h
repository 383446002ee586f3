// Values of JSON.
#pragma once

#include <stdint.h>
#include <stdio.h>

void print_text(const char* text, FILE* out);

// As a list; each is read back as it is.
void print_numbers(const double* numbers, uint32_t count, FILE* out);
