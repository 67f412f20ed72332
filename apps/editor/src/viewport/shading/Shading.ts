/** Shading without the scene's lights. */
export type PlainShadingName = 'unlit' | 'clay' | 'wireframe';

/** Shading of a view: the scene's technique, one without lights, or 'by:' and the name of a technique. */
export type Shading = 'scene' | PlainShadingName | `by:${string}`;

export const isPlain = (shading: string): shading is PlainShadingName =>
  shading === 'unlit' || shading === 'clay' || shading === 'wireframe';

/** Technique of a 'by:' shading; null for others. */
export const techniqueOf = (shading: Shading): string | null => (shading.startsWith('by:') ? shading.slice(3) : null);

export const isShading = (value: unknown): value is Shading =>
  typeof value === 'string' && (value === 'scene' || isPlain(value) || value.startsWith('by:'));
