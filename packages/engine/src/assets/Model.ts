import type { PhotometricProfile } from '@farol/renderer/light-profiles';
import type { AnimationClip, BufferGeometry, Material, Object3D, Skeleton, Texture } from 'three';

/**
 * A tree of three objects that was read from a file such as a glTF, with its animations. The tree itself is never in a
 * scene; copies are.
 */
export class Model {
  readonly isModel = true;
  name = '';
  /** Animations of the model as assets. */
  readonly clips: readonly ModelClip[];

  constructor(
    readonly scene: Object3D,
    readonly animations: readonly AnimationClip[] = [],
    /** Photometric profiles of the model's lights. */
    readonly profiles: readonly PhotometricProfile[] = [],
  ) {
    this.clips = animations.map((clip) => new ModelClip(clip, this));
  }

  /** Frees the GPU memory of all parts; drawing again uploads again. */
  dispose(): void {
    const disposables = new Set<{ dispose(): void }>();
    this.scene.traverse((object) => {
      const { geometry, material, skeleton } = object as {
        geometry?: BufferGeometry;
        material?: Material | Material[];
        skeleton?: Skeleton;
      };
      if (geometry) disposables.add(geometry);
      if (skeleton) disposables.add(skeleton);
      for (const each of material === undefined ? [] : [material].flat()) {
        disposables.add(each);
        for (const texture of texturesOf(each)) disposables.add(texture);
      }
    });
    for (const each of [...disposables, ...this.profiles]) each.dispose();
  }

  /** Profile of a light of the model, or of the light's copy; null for none. */
  profileOf(light: Object3D): PhotometricProfile | null {
    const texture: unknown = light.userData.farolProfile;
    if (!texture) return null;
    return this.profiles.find((each) => each.texture === texture) ?? null;
  }
}

/** A clip of a model, a part of it in a library: 'robot.glb/clip-1-Walk'. Its tracks name nodes of the model. */
export class ModelClip {
  readonly isModelClip = true;

  constructor(
    readonly three: AnimationClip,
    readonly model: Model,
  ) {}

  /** Name of the animation in the model's file. */
  get name(): string {
    return this.three.name;
  }

  /** Duration of the animation (s). */
  get duration(): number {
    return this.three.duration;
  }

  dispose(): void {}
}

/** Textures that a material uses. */
export function texturesOf(material: Material): Texture[] {
  return Object.values(material).filter((value): value is Texture =>
    Boolean((value as { isTexture?: boolean } | null)?.isTexture),
  );
}
