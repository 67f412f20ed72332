import type { ParticleSettings } from './ParticleSettings';

/** Says which values are allowed, in words that follow "give"; null when the value is allowed. */
type Check = (value: unknown) => string | null;

/** Maximum number of particles of an emitter: 1024 × 1024 texels. */
export const MOST_PARTICLES = 1_048_576;
/** Maximum number of colliders of an emitter; particleMotion.glsl repeats it. */
export const MOST_COLLIDERS = 4;

const isNumber = (value: unknown, least = -Infinity, most = Infinity): boolean =>
  typeof value === 'number' && Number.isFinite(value) && value >= least && value <= most;
const isList = (value: unknown): value is readonly unknown[] => Array.isArray(value);

function words(least: number, most: number, whole = false): string {
  const kind = whole ? 'whole number' : 'number';
  if (most < Infinity) return `${kind} from ${least} to ${most}`;
  return least > -Infinity ? `${kind} of at least ${least}` : `finite ${kind}`;
}

const number =
  (least = -Infinity, most = Infinity): Check =>
  (value) =>
    isNumber(value, least, most) ? null : `a ${words(least, most)}`;

const whole =
  (least: number, most: number): Check =>
  (value) =>
    isNumber(value, least, most) && Number.isInteger(value) ? null : `a ${words(least, most, true)}`;

const range =
  (least = -Infinity, above = false): Check =>
  (value) => {
    const [low, high] = isList(value) && value.length === 2 ? value : [];
    if (isNumber(low, least) && isNumber(high, low as number) && !(above && low === least)) return null;
    const bound = least === -Infinity ? 'finite numbers' : `numbers ${above ? 'above' : 'of at least'} ${least}`;
    return `two ${bound}, the first at most the second`;
  };

const isVector = (value: unknown): boolean => isList(value) && value.length === 3 && value.every((n) => isNumber(n));
const vector: Check = (value) => (isVector(value) ? null : 'three finite numbers');
const boolean: Check = (value) => (typeof value === 'boolean' ? null : 'true or false');

const oneOf =
  (...names: readonly string[]): Check =>
  (value) =>
    names.includes(value as string) ? null : `one of: ${names.join(', ')}`;

/** @param what - allowed value in words, put after "null or" */
const orNull =
  (isIt: (value: object) => boolean, what: string): Check =>
  (value) =>
    value === null || (typeof value === 'object' && isIt(value)) ? null : `null or ${what}`;

const keys =
  (isValue: (key: readonly unknown[]) => boolean, what: string): Check =>
  (value) => {
    const list = isList(value) ? value : [];
    let last = 0;
    const fits = list.every((key) => {
      if (!isList(key) || !isNumber(key[0], last, 1) || !isValue(key)) return false;
      last = key[0] as number;
      return true;
    });
    return list.length > 0 && fits ? null : `at least one key of a time from 0 to 1, ascending, ${what}`;
  };

const curve = keys((key) => isNumber(key[1]), 'and a finite number');
const isColor = (value: unknown): boolean => isVector(value) && (value as number[]).every((n) => n >= 0);
const gradient = keys(
  (key) => isColor(key[1]) && isNumber(key[2], 0, 1),
  'a colour of three numbers of at least 0, and an opacity from 0 to 1',
);

const bursts: Check = (value) =>
  isList(value) &&
  value.every((burst) => {
    const { time, count } = (burst ?? {}) as Record<string, unknown>;
    return isNumber(time, 0) && isNumber(count, 0, MOST_PARTICLES) && Number.isInteger(count);
  })
    ? null
    : 'a list of bursts, each of a time of at least 0 and a whole count';

const shape: Check = (value) => {
  const { kind, ...rest } = (value ?? {}) as Record<string, unknown>;
  const { radius, thickness, angle, size, mesh } = rest;
  switch (kind) {
    case 'point':
      return null;
    case 'sphere':
      return isNumber(radius, 0) && isNumber(thickness, 0, 1)
        ? null
        : 'a sphere with a radius of at least 0 and a thickness from 0 to 1';
    case 'cone':
      return isNumber(radius, 0) && isNumber(angle, 0, Math.PI / 2)
        ? null
        : 'a cone with a radius of at least 0 and an angle from 0 to π/2';
    case 'box':
      return isVector(size) && (size as number[]).every((side) => side >= 0)
        ? null
        : 'a box with three sides of at least 0';
    case 'mesh':
      return mesh === null || (mesh as { isMesh?: boolean } | undefined)?.isMesh === true
        ? null
        : 'a mesh shape whose mesh is a Mesh or null';
    default:
      return 'a shape of the kind point, sphere, cone, box or mesh';
  }
};

const isCollider = (value: unknown): boolean => {
  const { kind, normal, height, center, radius, bounce, friction } = (value ?? {}) as Record<string, unknown>;
  if (!isNumber(bounce, 0, 1) || !isNumber(friction, 0, 1)) return false;
  if (kind === 'sphere') return isVector(center) && isNumber(radius) && (radius as number) > 0;
  return kind === 'plane' && isVector(normal) && Math.hypot(...(normal as number[])) > 0 && isNumber(height);
};

const colliders: Check = (value) =>
  isList(value) && value.length <= MOST_COLLIDERS && value.every(isCollider)
    ? null
    : `at most ${MOST_COLLIDERS} colliders, each a plane with a normal that is not zero and a finite height, or a sphere ` +
      'with a center and a radius above 0, and with bounce and friction from 0 to 1';

const flipBook = orNull((value) => {
  const { columns, rows, cycles = 1 } = value as Record<string, unknown>;
  const isCount = (count: unknown) => isNumber(count, 1) && Number.isInteger(count);
  return isCount(columns) && isCount(rows) && isNumber(cycles, 0);
}, 'a flip-book with at least one column and row, and cycles of at least 0');

const checks: { readonly [Name in keyof ParticleSettings]: Check } = {
  capacity: whole(1, MOST_PARTICLES),
  seed: number(),
  rate: number(0),
  bursts,
  duration: number(0),
  loop: boolean,
  prewarm: number(0, 60),
  delay: number(0),
  space: oneOf('world', 'local'),
  shape,
  life: range(0, true),
  speed: range(),
  inheritVelocity: number(),
  gravity: vector,
  drag: number(0),
  noiseStrength: number(),
  noiseFrequency: number(0),
  noiseScroll: number(),
  colliders,
  size: range(0),
  sizeOverLife: curve,
  colorOverLife: gradient,
  brightness: number(0),
  initialRotation: range(),
  spin: range(),
  spinOverLife: curve,
  texture: orNull((value) => (value as { isTexture?: boolean }).isTexture === true, 'a Texture'),
  flipBook,
  render: oneOf('billboard', 'stretched', 'mesh'),
  stretch: number(0),
  orientation: oneOf('random', 'emitter', 'velocity'),
  particleGeometry: orNull(
    (value) => (value as { isBufferGeometry?: boolean }).isBufferGeometry === true,
    'a BufferGeometry',
  ),
  blending: oneOf('blended', 'additive', 'weighted'),
  softness: number(0),
  lit: boolean,
  receiveShadow: boolean,
  lightEvery: whole(0, MOST_PARTICLES),
  lightIntensity: number(0),
  lightRange: number(0),
};

export const settingNames = Object.keys(checks) as readonly (keyof ParticleSettings)[];

/** @throws RangeError for a name of no setting */
export function checkParticleName(owner: string, name: string): void {
  if (Object.hasOwn(checks, name)) return;
  throw new RangeError(`${owner}: ${shortText(name)} is no setting; the settings are ${settingNames.join(', ')}.`);
}

/** @param owner - name of the emitter, for the message @throws RangeError that names the setting and its allowed values */
export function checkParticleSetting(owner: string, name: keyof ParticleSettings, value: unknown): void {
  const wanted = checks[name](value);
  if (wanted !== null) throw new RangeError(`${owner}: ${name} is ${shortText(value)}; give ${wanted}.`);
}

function shortText(value: unknown): string {
  if (typeof value === 'number' || typeof value === 'boolean' || value === undefined) return String(value);
  // JSON has no Infinity and NaN: writes their names
  const text = JSON.stringify(value, (key, part: unknown) => {
    if (key === 'mesh' || key === 'metadata') return undefined;
    return typeof part === 'number' && !Number.isFinite(part) ? String(part) : part;
  });
  return text.length > 80 ? `${text.slice(0, 77)}...` : text;
}
