import type { Component, ComponentClass, GameObject, Scene } from '@farol/engine';

/** Component type that plays clips, and its field for the clip. */
const PLAYER = { type: 'Animation', field: 'clip' } as const;

/** The component class that plays clips, and its field for the clip; null when the scene lacks the class. */
export function clipPlayer({ registry }: Scene): { readonly type: ComponentClass; readonly field: string } | null {
  const type = registry.types.get(PLAYER.type);
  return type ? { type, field: PLAYER.field } : null;
}

const componentOn = (object: GameObject): Component | null => object.getComponent(PLAYER.type);

/** The closest object that plays clips: the given one or an ancestor. */
export function playerAbove(object: GameObject): GameObject | null {
  for (let at: GameObject | null = object; at; at = at.parent) if (componentOn(at)) return at;
  return null;
}

/** The first object of a scene that plays a clip; null when none does. */
export const playerOfClip = (scene: Scene, clip: string): GameObject | null =>
  scene.componentsOf(PLAYER.type).find((component) => component.getAuthored(PLAYER.field) === clip)?.gameObject ?? null;

/** Name of the clip that an object plays; null for none. */
export const playedClip = (object: GameObject): string | null =>
  (componentOn(object)?.getAuthored(PLAYER.field) as string | null | undefined) ?? null;

/** Time in a clip that an object plays (s); null while it does not play this clip. */
export function playedTime(object: GameObject, clip: string): number | null {
  const { playing, time } = (componentOn(object) ?? {}) as { readonly playing?: unknown; readonly time?: unknown };
  return playing === clip && typeof time === 'number' ? time : null;
}
