/** A unit as a factor and powers of SI units: km/h is 1/3.6, with m to the power 1 and s to the power -1. */
export interface Unit {
  readonly factor: number;
  /** Non-zero powers, by the name of the SI unit. Angles have none. */
  readonly powers: Readonly<Record<string, number>>;
}

export const noUnit: Unit = { factor: 1, powers: {} };

const of = (base: string, table: Readonly<Record<string, number>>): [string, Unit][] =>
  Object.entries(table).map(([name, factor]) => [name, { factor, powers: { [base]: 1 } }]);

const DEGREE = Math.PI / 180;

/** Units that can be typed. A field's own unit need not be among them. */
const known = new Map<string, Unit>([
  ...of('m', { m: 1, km: 1e3, cm: 1e-2, mm: 1e-3, µm: 1e-6, um: 1e-6, nm: 1e-9 }),
  ...of('m', { in: 0.0254, '"': 0.0254, ft: 0.3048, "'": 0.3048, yd: 0.9144, mi: 1609.344 }),
  ...of('rad', { rad: 1, mrad: 1e-3, deg: DEGREE, '°': DEGREE, turn: 2 * Math.PI, turns: 2 * Math.PI }),
  ...of('s', { s: 1, ms: 1e-3, µs: 1e-6, us: 1e-6, min: 60, h: 3600 }),
  ...of('W', { W: 1, kW: 1e3, mW: 1e-3 }),
  ...of('cd', { cd: 1, kcd: 1e3 }),
  ...of('lm', { lm: 1, klm: 1e3 }),
  ...of('lx', { lx: 1, klx: 1e3 }),
  ['nt', { factor: 1, powers: { cd: 1, m: -2 } }],
  ['Hz', { factor: 1, powers: { s: -1 } }],
  ['kHz', { factor: 1e3, powers: { s: -1 } }],
  ['%', { factor: 0.01, powers: {} }],
]);

/** A unit that can be typed into a field, in any letter case; null for another word. @param unit - unit of the field */
export function unitOf(word: string, unit?: string): Unit | null {
  const own =
    known.get(word) ?? (unit?.split(/ or |[/²³]/).includes(word) ? { factor: 1, powers: { [word]: 1 } } : null);
  return own ?? known.get(word.toLowerCase()) ?? null;
}

export function multiplyUnits(a: Unit, b: Unit, power: number): Unit {
  const powers: Record<string, number> = { ...a.powers };
  for (const [name, each] of Object.entries(b.powers)) {
    const sum = (powers[name] ?? 0) + each * power;
    if (sum === 0) delete powers[name];
    else powers[name] = sum;
  }
  return { factor: a.factor * b.factor ** power, powers };
}

export const isPure = ({ powers }: Unit): boolean => Object.keys(powers).length === 0;

/** Whether two units measure the same quantity, such as length. */
export function isAlike(a: Unit, b: Unit): boolean {
  const names = Object.keys(a.powers);
  return names.length === Object.keys(b.powers).length && names.every((name) => a.powers[name] === b.powers[name]);
}

/** Units of a field's numbers: one for 'm/s' or '1/m²', two for 'cd or lx'; the pure number for an absent unit. */
export function unitsOfField(unit: string | undefined): readonly Unit[] {
  if (!unit) return [noUnit];
  return unit.split(' or ').map((alternative) =>
    alternative.split('/').reduce((product, part, i) => {
      const power = part.endsWith('²') ? 2 : part.endsWith('³') ? 3 : 1;
      const word = part.replace(/[²³]$/, '');
      if (word === '1' || word === '' || word === '×') return product;
      const factor = unitOf(word, unit) ?? { factor: 1, powers: { [word]: 1 } };
      return multiplyUnits(product, factor, i === 0 ? power : -power);
    }, noUnit),
  );
}
