/** Shadings without the scene's lights. */
export type PlainShadingName = 'unlit' | 'clay' | 'wireframe';

/**
 * Shading of a view: the scene's technique, one without lights, 'by:' and the name of a technique, or 'view:' and the name of a
 * debug view.
 */
export type Shading = 'scene' | PlainShadingName | `${'by' | 'view'}:${string}`;

export const isPlain = (shading: string): shading is PlainShadingName =>
  shading === 'unlit' || shading === 'clay' || shading === 'wireframe';

const named = (kind: string, shading: string): string | null =>
  shading.startsWith(kind) ? shading.slice(kind.length) : null;

/** Technique of a 'by:' shading; null for others. */
export const techniqueOf = (shading: Shading): string | null => named('by:', shading);

/** Debug view of a 'view:' shading; null for others. */
export const viewOf = (shading: Shading): string | null => named('view:', shading);

export const isShading = (value: unknown): value is Shading =>
  typeof value === 'string' && (value === 'scene' || isPlain(value) || /^(by|view):/.test(value));
