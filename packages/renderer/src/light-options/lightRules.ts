import type { LightOptions } from './LightOptions';

/** Kinds of lights, named as in three's flags: `isPointLight`. */
export type LightKind = 'DirectionalLight' | 'PointLight' | 'SpotLight' | 'RectAreaLight';

export type LightOptionName = keyof LightOptions;

interface LightRule {
  /** Kinds of lights that have the option. */
  readonly kinds: readonly LightKind[];
  /** Allowed values, in words that follow "give". */
  readonly allows: string;
  isAllowed(value: unknown): boolean;
}

const isFrom = (value: unknown, min: number, max = Infinity): boolean =>
  typeof value === 'number' && Number.isFinite(value) && value >= min && value <= max;
const isAtLeastZero = (value: unknown): boolean => isFrom(value, 0);
const isColour = (value: unknown): boolean => Array.isArray(value) && value.length === 3 && value.every(isAtLeastZero);

function isAttenuation(value: unknown): boolean {
  const { kind, near, far, constant, linear, quadratic, range } = (value ?? {}) as Record<string, unknown>;
  if (kind === 'near-far') return isAtLeastZero(near) && isFrom(far, near as number);
  const factors = [constant, linear, quadratic];
  return kind === 'polynomial' && [...factors, range].every(isAtLeastZero) && factors.some((factor) => factor !== 0);
}

const isTexture = (value: unknown, flag: string): boolean =>
  value === null || (typeof value === 'object' && flag in value);

const surfaces: readonly LightKind[] = ['DirectionalLight', 'PointLight', 'SpotLight'];
const local: readonly LightKind[] = ['PointLight', 'SpotLight'];
const area: readonly LightKind[] = ['RectAreaLight'];
const colour = '[r, g, b], linear, each at least 0';
const SHAPES = ['rectangle', 'disc', 'tube'];

/**
 * Kinds of lights and allowed values of each option. No call at the top level, so that bundlers can drop the table where nothing
 * is checked.
 */
export const lightRules: Readonly<Record<LightOptionName, LightRule>> = {
  ambient: { kinds: surfaces, allows: colour, isAllowed: isColour },
  specular: { kinds: surfaces, allows: colour, isAllowed: isColour },
  spotExponent: { kinds: ['SpotLight'], allows: 'a number of at least 0', isAllowed: isAtLeastZero },
  attenuation: {
    kinds: local,
    allows:
      "{ kind: 'near-far', near, far } with far of at least near, or { kind: 'polynomial', constant, linear, quadratic, range }, each number at least 0",
    isAllowed: isAttenuation,
  },
  shape: { kinds: area, allows: 'rectangle, disc, tube', isAllowed: (value) => SHAPES.includes(value as string) },
  range: { kinds: area, allows: 'metres, at least 0', isAllowed: isAtLeastZero },
  shadowMapSize: { kinds: area, allows: 'texels from 16 to 8192', isAllowed: (value) => isFrom(value, 16, 8192) },
  shadowNormalBias: { kinds: area, allows: 'metres, at least 0', isAllowed: isAtLeastZero },
  radius: { kinds: local, allows: 'metres, at least 0', isAllowed: isAtLeastZero },
  angle: {
    kinds: ['DirectionalLight'],
    allows: 'radians from 0 to π',
    isAllowed: (value) => isFrom(value, 0, Math.PI),
  },
  cookie: {
    kinds: ['PointLight'],
    allows: 'a CubeTexture or null',
    isAllowed: (value) => isTexture(value, 'isCubeTexture'),
  },
  profile: { kinds: local, allows: 'a Texture or null', isAllowed: (value) => isTexture(value, 'isTexture') },
};
