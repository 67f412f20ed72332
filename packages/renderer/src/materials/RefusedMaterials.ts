import type { Material, Object3D, ShaderMaterial } from 'three';
import { threeChunks } from '../three/ThreeChunks';

/** Frames for which three goes on lighting a scene in which no refused material is seen any more. */
const KEPT_FRAMES = 600;

/** Matches GLSL that reads three's arrays of lights or its ambient light. */
const READS_LIGHTS = /\b(directional|point|spot|hemisphere)Lights\b|ambientLightColor/;

const versionOf = ({ version }: Material) => version * 65536 + threeChunks.revision;

/**
 * The materials whose shaders have no place for Farol's loop over the lights, since the host has changed three's: three's own
 * lights alone are right for them. A scene that shows one is lit by three, all of it.
 */
export class RefusedMaterials {
  private readonly versions = new WeakMap<Material, number>();
  private readonly readers = new WeakMap<Material, { readonly text: string; readonly reads: boolean }>();
  private readonly scenes = new WeakMap<Object3D, number>();
  /** One was met in the frame. */
  private met = false;

  /** The version of a material that is drawn now is refused. */
  refuse(material: Material): void {
    this.versions.set(material, versionOf(material));
    this.met = true;
  }

  /** Whether a material has been refused, and has not been changed since. */
  has(material: Material): boolean {
    if (this.versions.get(material) !== versionOf(material)) return false;
    return (this.met = true);
  }

  /** Looks at a shader material that is not lit light by light: one that reads three's lights by itself counts as refused. */
  look(material: ShaderMaterial): void {
    let reader = this.readers.get(material);
    const text = material.fragmentShader;
    if (reader?.text !== text) {
      this.readers.set(material, (reader = { text, reads: READS_LIGHTS.test(text + material.vertexShader) }));
    }
    if (reader.reads) this.met = true;
  }

  /** Begins a frame. @returns whether three is to light the scene */
  begin(scene: Object3D): boolean {
    this.met = false;
    return (this.scenes.get(scene) ?? 0) > 0;
  }

  /** Ends a frame. @returns whether it has to be drawn once more, with three's lights */
  end(scene: Object3D, isLitByThree: boolean): boolean {
    const left = this.met ? KEPT_FRAMES : (this.scenes.get(scene) ?? 0) - 1;
    if (this.met || isLitByThree) this.scenes.set(scene, left);
    return this.met && !isLitByThree;
  }
}
