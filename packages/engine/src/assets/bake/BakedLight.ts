import type { BakeData } from './BakeData';

/**
 * An asset of type 'bake': light of a scene that was baked. `scene.settings.bakedLight` names the one that lights a scene.
 */
export class BakedLight {
  readonly isBakedLight = true;
  name = '';

  constructor(readonly data: BakeData) {}

  dispose(): void {}
}
