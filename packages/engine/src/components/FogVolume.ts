import { choice, colour, number, vector3 } from '@farol/editing/fields';
import type { FogVolume as ThreeVolume } from '@farol/renderer/volumetric-fog';
import { LateCode } from '../base/LateCode';
import { component } from '../core/Component';
import type { NewObject } from '../core/NewObject';
import type { Scene } from '../core/Scene';

/** @internal The renderer's code of fog, which most scenes do not need. */
export const fogCode = new LateCode(
  () => import('@farol/renderer/volumetric-fog'),
  'The code of fog could not be fetched: see that the network is there, and add one again.',
);

/**
 * Fog in a box or ball around the GameObject, added to that of the scene: `FogVolume` of
 * @farol/renderer/volumetric-fog, fetched when a scene first has one. Drawn with the scene's effect "Volumetric fog".
 */
export class FogVolume extends component({
  shape: choice('box', ['box', 'sphere'], {
    help: 'Shape of the fog.',
    optionLabels: { box: 'Box', sphere: 'Sphere' },
  }),
  size: vector3([4, 2, 4], { unit: 'm', min: 0.001, step: 0.1, help: 'Width, height and depth.' }),
  density: number(0.2, {
    unit: '1/m',
    min: -10,
    max: 10,
    step: 0.01,
    help: 'Added to the fog of the scene; below 0 it takes fog away, as in a room.',
  }),
  colour: colour([1, 1, 1], { help: 'Share of light that the fog scatters; the rest is absorbed.' }),
  softness: number(0.5, { min: 0, max: 1, step: 0.05, help: 'Depth at which it has its full density.' }),
}) {
  static override readonly typeName: string = 'FogVolume';
  static override readonly icon: string = 'fog';
  static override readonly help: string = 'Fog in a box or a ball, while Volumetric fog is on.';
  static override readonly newObjects: readonly NewObject[] = [{ label: 'Fog volume' }];

  private volume: ThreeVolume | null = null;

  /** The volume below the GameObject's object3D; null outside a scene, and until the late code is loaded. */
  get three(): ThreeVolume | null {
    return this.volume;
  }

  override onEnterScene(scene: Scene): void {
    const code = fogCode.codeOr(() => {
      if (this.scene === scene && this.volume === null) this.onEnterScene(scene);
    });
    if (code === null) return;
    this.volume = new code.FogVolume();
    this.gameObject.object3D.add(this.volume);
    this.apply();
  }

  override onLeaveScene(): void {
    this.volume?.removeFromParent();
    this.volume = null;
  }

  override onFieldChanged(): void {
    this.apply();
  }

  override onActiveChanged(): void {
    this.apply();
  }

  private apply(): void {
    const { volume, shape, density, softness } = this;
    if (!volume) return;
    Object.assign(volume, { shape, density, softness, visible: this.enabled });
    volume.albedo.fromArray(this.colour);
    volume.scale.set(...this.size);
  }
}
