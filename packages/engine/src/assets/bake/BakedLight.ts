import type { BakeData } from './BakeData';

/**
 * An asset of type 'bake': the baked light of a scene. `scene.settings.bakedLight` names the asset that a scene uses.
 */
export class BakedLight {
  readonly isBakedLight = true;
  name = '';

  constructor(readonly data: BakeData) {}

  dispose(): void {}
}
