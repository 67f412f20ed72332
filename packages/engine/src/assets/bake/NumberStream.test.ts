import { expect, test } from 'vitest';
import { NumberReader, NumberWriter } from './NumberStream';

test('numbers of all lengths are read as they were written, wherever the buffer has to grow', () => {
  for (let shift = 0; shift < 6; shift++) {
    const values = Array.from({ length: 900 }, (_, i) => (i < shift ? 0 : i % 2 === 0 ? 2 ** 30 - i : i - 2 ** 30));
    const writer = new NumberWriter();
    for (const value of values) writer.write(value);
    const reader = new NumberReader(writer.result);
    expect(values.map(() => reader.read())).toEqual(values);
    expect(reader.isAtEnd).toBe(true);
  }
});
