/** Without the scene's lights. */
export type PlainShadingName = 'unlit' | 'clay' | 'wireframe';

/** How a view shows the scene: as the scene says, without its lights, or, with 'by:' before it, by a technique. */
export type Shading = 'scene' | PlainShadingName | `by:${string}`;

export const isPlain = (shading: string): shading is PlainShadingName =>
  shading === 'unlit' || shading === 'clay' || shading === 'wireframe';

/** The technique of a shading; null where it is another. */
export const techniqueOf = (shading: Shading): string | null => (shading.startsWith('by:') ? shading.slice(3) : null);

/** Whether something that was stored is a shading. */
export const isShading = (value: unknown): value is Shading =>
  typeof value === 'string' && (value === 'scene' || isPlain(value) || value.startsWith('by:'));
