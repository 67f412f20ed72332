import { variantOfField } from '@farol/editing/fields';
import { describe, expect, it } from 'vitest';
import { lightFields } from '../components/lightFields';

const shown = (name: 'width' | 'height' | 'intensity' | 'range', type: unknown) =>
  variantOfField(lightFields[name], () => type);

describe('a field that has another label or unit while another field has a value', () => {
  it('is the field itself where it has no variant', () => {
    expect(shown('range', 'tube')).toBe(lightFields.range);
    expect(shown('width', 'rectangle')).toBe(lightFields.width);
    expect(shown('width', 'toString')).toBe(lightFields.width);
    expect(shown('width', null)).toBe(lightFields.width);
  });

  it('is what the variant says, and all else as before, the same object each time', () => {
    const tube = shown('width', 'tube');
    expect(tube).toEqual({ ...lightFields.width, label: 'Length' });
    expect(shown('width', 'tube')).toBe(tube);
    expect(shown('height', 'tube').label).toBe('Thickness');
  });

  it('gives the intensity of each kind of light its unit', () => {
    const types = lightFields.type.options;
    expect(types.map((type) => (shown('intensity', type) as { unit?: string }).unit)).toEqual([
      ...['lx', 'lx', 'lx', 'cd', 'cd'],
      ...['nt', 'nt', 'nt'],
    ]);
  });
});
