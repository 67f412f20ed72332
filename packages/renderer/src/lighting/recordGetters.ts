import { capital } from '../microshaders/capital';
import { TEXELS_PER_RECORD } from '../lights/lightRecord';
import type { RecordLayout } from '../lights/recordLayout';

const TYPES = ['', 'float', 'vec2', 'vec3', 'vec4'];

/**
 * GLSL functions that read a record of the light table: `vec4 farol_<prefix><Texel>(record)` for each texel, and
 * `farol_<prefix><Value>` for each value, from a record or a fetched texel. Layouts with more texels than a record continue in
 * the next records.
 * @param prefix - prefix such as `light`: `farol_lightRange(record)`, `farol_lightRange(farol_lightSphere(record))`
 * @param fetches - texels that are fetched by a custom function, `farol_<texel>Texel(record)`. Default none
 */
export function recordGetters(prefix: string, layout: RecordLayout, fetches: readonly string[] = []): string {
  const lines: string[] = [];
  const add = (type: string, name: string, of: string, value: string) =>
    lines.push(`${type} farol_${prefix}${capital(name)}(${of}) { return ${value}; }`);
  Object.entries(layout).forEach(([texel, values], i) => {
    const record = i < TEXELS_PER_RECORD ? 'record' : `record + ${Math.floor(i / TEXELS_PER_RECORD)}`;
    const fetched = fetches.includes(texel)
      ? `farol_${texel}Texel(${record})`
      : `farol_lightTexel(${record}, ${i % TEXELS_PER_RECORD})`;
    if (!(texel in values)) add('vec4', texel, 'int record', fetched);
    for (const [name, value] of Object.entries(values)) {
      const [type, expression] = typeof value === 'string' ? [TYPES[value.length], `t.${value}`] : value;
      add(type, name, 'vec4 t', expression);
      if (expression.split('t.').length === 2)
        add(type, name, 'int record', expression.replace(/\bt\./, `${fetched}.`));
    }
  });
  return lines.join('\n');
}
