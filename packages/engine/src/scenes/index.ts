import type { SceneDefinition } from './SceneDefinition';
import { templeScene } from './temple/temple';

/** The scenes that the apps offer, by name. */
export const scenes: Readonly<Record<string, SceneDefinition>> = Object.fromEntries(
  [templeScene].map((scene) => [scene.name, scene]),
);
