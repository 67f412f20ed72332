import { angle, asset, choice, colour, number, vector3 } from '@farol/editing/fields';
import type { Decal as ThreeDecal } from '@farol/renderer/decals';
import {
  AdditiveBlending,
  type MeshStandardMaterial,
  MultiplyBlending,
  NormalBlending,
  SubtractiveBlending,
} from 'three';
import { materialFields, type MaterialValues } from '../assets/materialFields';
import { component } from '../core/Component';
import type { NewObject } from '../core/NewObject';
import type { RequiredEffect } from '../core/RequiredEffect';
import type { Scene } from '../core/Scene';
import { decalCode, decalsEffect } from './decalCode';

const blendings = {
  normal: NormalBlending,
  additive: AdditiveBlending,
  subtractive: SubtractiveBlending,
  multiply: MultiplyBlending,
} as const;

const covers = { visibleWhen: { field: 'blending', equals: ['normal'] } };

const defaults = Object.fromEntries(
  Object.entries(materialFields).map(([name, field]) => [name, field.default]),
) as unknown as MaterialValues;

/**
 * Projects a picture on surfaces in a box around the GameObject, along the object's z axis, seen from +z: `Decal` of
 * @farol/renderer/decals. An `App` switches the effect on while its scene has decals. Drawn by techniques with a
 * G-buffer.
 */
export class Decal extends component({
  size: vector3([0.8, 0.8, 1.2], {
    unit: 'm',
    min: 0.001,
    step: 0.1,
    help: 'Width and height of the picture, and how deep it reaches.',
  }),
  colour: colour([0.8, 0.1, 0.05], { help: 'Diffuse colour; multiplies the map.' }),
  map: asset('texture', null, { help: 'Texture of the colour; where its alpha is 0 the surface stays as it is.' }),
  blending: choice('normal', ['normal', 'additive', 'subtractive', 'multiply'], {
    help: 'How the colour meets the surface’s: covers it, is added to it, takes its own share from it, or multiplies it.',
  }),
  normalMap: asset('texture', null, { help: 'Texture of bumps, in tangent space.', label: 'Normal map' }),
  normalScale: number(1, {
    step: 0.05,
    help: 'Strength of the bumps; below 0 they are inverted.',
    label: 'Bump strength',
  }),
  roughness: number(0.6, { min: 0, max: 1, step: 0.01, help: '0 is a mirror, 1 is chalk.', ...covers }),
  metalness: number(0, { min: 0, max: 1, step: 0.01, help: '0 for insulators, 1 for metals.', ...covers }),
  opacity: number(1, { min: 0, max: 1, step: 0.01, help: 'How much of it is visible; 0 is nothing.' }),
  maximumAngle: angle(Math.PI / 2, {
    min: 0,
    max: Math.PI,
    help: 'Surfaces at a larger angle to it are left out.',
    label: 'Maximum angle',
  }),
  order: number(0, { integer: true, min: -1000, max: 1000, help: 'Where decals overlap, the highest is on top.' }),
}) {
  static override readonly typeName: string = 'Decal';
  static override readonly icon: string = 'decal';
  static override readonly help: string = 'A picture on whatever surface lies in a box.';
  /** Rotation to point down, as decals project along -Z. */
  static override readonly newObjects: readonly NewObject[] = [{ label: 'Decal', rotation: [-Math.PI / 2, 0, 0] }];
  static override readonly effect: RequiredEffect = decalsEffect;

  private box: ThreeDecal | null = null;
  private material: MeshStandardMaterial | null = null;

  /** The decal below the GameObject's object3D; null outside a scene, and until the late code is loaded. */
  get three(): ThreeDecal | null {
    return this.box;
  }

  override onEnterScene(scene: Scene): void {
    const code = decalCode.codeOr(() => {
      if (this.scene === scene && this.box === null) this.onEnterScene(scene);
    });
    if (code === null) return;
    this.material = scene.assets.materials.acquire(this.surface()) as MeshStandardMaterial;
    this.box = new code.Decal(this.material);
    this.box.name = this.gameObject.name;
    this.gameObject.object3D.add(this.box);
    this.apply();
  }

  override onLeaveScene(scene: Scene): void {
    this.box?.removeFromParent();
    this.box = null;
    if (this.material) scene.assets.materials.release(this.material);
    this.material = null;
  }

  override onFieldChanged(): void {
    if (!this.scene || !this.box || !this.material) return;
    this.material = this.scene.assets.materials.change(this.material, this.surface()) as MeshStandardMaterial;
    this.box.surface = this.material;
    this.apply();
  }

  override onActiveChanged(): void {
    this.apply();
  }

  private surface(): MaterialValues {
    const { colour, map, normalMap, normalScale, roughness, metalness, opacity } = this;
    const blending = blendings[this.blending];
    const made = { colour, map, normalMap, normalScale, roughness, metalness, opacity, blending };
    return { ...defaults, ...made, transparent: true };
  }

  private apply(): void {
    const { box } = this;
    if (!box) return;
    box.scale.set(...this.size);
    box.maximumAngle = this.maximumAngle;
    box.renderOrder = this.order;
    box.visible = this.enabled;
  }
}
