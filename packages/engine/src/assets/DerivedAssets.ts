import { type BufferGeometry, type Material, NoColorSpace, RepeatWrapping, SRGBColorSpace, type Texture } from 'three';
import type { BakedLight } from './bake/BakedLight';
import type { ClipAsset } from './clips/ClipAsset';
import { MeshNormals } from './MeshNormals';
import type { Model, ModelClip } from './Model';
import type { PhotometricProfile } from '@farol/renderer/light-profiles';
import type { Sound } from './Sound';
import { LoadedAssets } from './LoadedAssets';

/** Crease angle of meshes where none is given (radians). */
const DEFAULT_CREASE = Math.PI / 6;

/** Typed access to assets, with derived ones: meshes with normals, repeated textures. */
export abstract class DerivedAssets extends LoadedAssets {
  protected readonly normals = new MeshNormals();
  /** Copies of textures, by texture name, then by repeat and by whether their texels are data. */
  protected readonly repeated: Map<string, Map<string, Texture>> = new Map();

  /**
   * A mesh's geometry. Missing normals are computed, smooth across edges of less than `creaseAngle` (radians), once for
   * each angle. For a large mesh that takes seconds: see `prepareMesh`.
   */
  mesh(name: string, creaseAngle = DEFAULT_CREASE): BufferGeometry {
    return this.normals.get(this.getAs<BufferGeometry>('mesh', name), creaseAngle);
  }

  /** Whether `mesh` returns at once, its normals being present or computed. */
  isMeshReady(name: string, creaseAngle = DEFAULT_CREASE): boolean {
    return this.isReady('mesh', name) && this.normals.isReady(this.getAs<BufferGeometry>('mesh', name), creaseAngle);
  }

  /**
   * Loads a mesh and computes its normals in slices, so that the page stays responsive; the result is that of `mesh`.
   * @param signal - cancels the wait, and the work when nobody else waits for it
   * @throws AssetError (as a rejection) when it is no mesh or cannot be loaded; the signal's abort reason
   */
  prepareMesh(name: string, creaseAngle = DEFAULT_CREASE, signal?: AbortSignal): Promise<BufferGeometry> {
    const prepare = (): Promise<BufferGeometry> =>
      this.normals.prepare(this.getAs<BufferGeometry>('mesh', name), creaseAngle, signal);
    return this.isReady('mesh', name) ? prepare() : this.load(name, signal).then(prepare);
  }

  /**
   * A texture, repeated `repeat` times over each unit of the texture coordinates.
   * @param isData - texels are data, such as normals, not sRGB colours
   */
  texture(name: string, repeat = 1, isData = false): Texture {
    const texture = this.getAs<Texture>('texture', name);
    const isDecoded = isData && texture.colorSpace === SRGBColorSpace;
    if (repeat === 1 && !isDecoded) return texture;
    let copies = this.repeated.get(name);
    if (!copies) this.repeated.set(name, (copies = new Map()));
    const key = `${repeat}${isDecoded ? ' data' : ''}`;
    let copy = copies.get(key);
    if (!copy) {
      copy = texture.clone();
      if (isDecoded) copy.colorSpace = NoColorSpace;
      if (repeat !== 1) {
        copy.wrapS = copy.wrapT = RepeatWrapping;
        copy.repeat.copy(texture.repeat).multiplyScalar(repeat);
      }
      copies.set(key, copy);
    }
    return copy;
  }

  material(name: string): Material {
    return this.getAs<Material>('material', name);
  }

  model(name: string): Model {
    return this.getAs<Model>('model', name);
  }

  sound(name: string): Sound {
    return this.getAs<Sound>('sound', name);
  }

  profile(name: string): PhotometricProfile {
    return this.getAs<PhotometricProfile>('profile', name);
  }

  /** Baked light by its asset's name. */
  bake(name: string): BakedLight {
    return this.getAs<BakedLight>('bake', name);
  }

  /** A clip asset, or a clip of a model. */
  clip(name: string): ClipAsset | ModelClip {
    return this.getAs<ClipAsset | ModelClip>('clip', name);
  }

  shader(name: string): Material {
    return this.getAs<Material>('shader', name);
  }

  /** Whether nothing is being loaded, and no normals are being computed. */
  get isSettled(): boolean {
    return this.loading.size === 0 && this.normals.isSettled;
  }

  /** Resolves when all loads and computations, also those begun meanwhile, are done or have failed. */
  async settled(): Promise<void> {
    while (!this.isSettled) await Promise.allSettled([...this.loading.values(), this.normals.settled()]);
  }

  /** Resolves when the normals that `prepareMesh` is computing now are done. */
  meshesPrepared(): Promise<void> {
    return this.normals.settled();
  }
}
