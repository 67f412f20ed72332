import type { Material, Object3D, ShaderMaterial } from 'three';
import { threeChunks } from '../three/ThreeChunks';

/** Number of frames for which three still lights a scene after its last refused material left the view. */
const KEPT_FRAMES = 600;

/** Matches GLSL that reads three's arrays of lights or its ambient light. */
const READS_LIGHTS = /\b(directional|point|spot|hemisphere)Lights\b|ambientLightColor/;

const versionOf = ({ version }: Material) => version * 65536 + threeChunks.revision;

/**
 * Materials whose shaders the host has changed so that Farol's light loop cannot be inserted: only three's own lights light
 * them. A scene with such a material is lit by three.
 */
export class RefusedMaterials {
  private readonly versions = new WeakMap<Material, number>();
  private readonly readers = new WeakMap<Material, { readonly text: string; readonly reads: boolean }>();
  private readonly scenes = new WeakMap<Object3D, number>();
  /** Whether the frame has drawn a material that Farol cannot light. */
  private hasDrawn = false;

  refuse(material: Material): void {
    this.versions.set(material, versionOf(material));
    this.hasDrawn = true;
  }

  /** Whether Farol was unable to light a material, which has not changed since. */
  has(material: Material): boolean {
    if (this.versions.get(material) !== versionOf(material)) return false;
    return (this.hasDrawn = true);
  }

  /** Checks a shader material without three's light loop: it counts as refused if it reads three's lights itself. */
  check(material: ShaderMaterial): void {
    let reader = this.readers.get(material);
    const text = material.fragmentShader;
    if (reader?.text !== text) {
      this.readers.set(material, (reader = { text, reads: READS_LIGHTS.test(text + material.vertexShader) }));
    }
    if (reader.reads) this.hasDrawn = true;
  }

  /** Begins a frame. @returns whether three must light the scene */
  begin(scene: Object3D): boolean {
    this.hasDrawn = false;
    return (this.scenes.get(scene) ?? 0) > 0;
  }

  /** Ends a frame. @returns whether it must be drawn again, with three's lights */
  end(scene: Object3D, isLitByThree: boolean): boolean {
    const left = this.hasDrawn ? KEPT_FRAMES : (this.scenes.get(scene) ?? 0) - 1;
    if (this.hasDrawn || isLitByThree) this.scenes.set(scene, left);
    return this.hasDrawn && !isLitByThree;
  }
}
