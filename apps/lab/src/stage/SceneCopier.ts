import { setShading, type ShadingName } from '@farol/renderer';
import {
  BufferGeometry,
  type Color,
  type InstancedMesh,
  type Material,
  type Mesh,
  type Object3D,
  Skeleton,
  type SkinnedMesh,
  Texture,
} from 'three';

/**
 * Copies meshes with geometries, materials and textures, so that each competitor's renderer can free its copies; arrays
 * and images are shared.
 */
export class SceneCopier {
  private readonly geometries = new Map<BufferGeometry, BufferGeometry>();
  private readonly materials = new Map<Material, Material>();
  private readonly textures = new Map<Texture, Texture>();
  private readonly instanced: InstancedMesh[] = [];

  /** Copies an object without its parent, at its current place in the world. */
  object(source: Object3D): Object3D {
    const copy = source.clone(false);
    copy.matrixAutoUpdate = false;
    copy.matrix.copy(source.matrixWorld);
    const mesh = copy as Mesh;
    mesh.geometry = this.geometry(mesh.geometry);
    mesh.material = Array.isArray(mesh.material)
      ? mesh.material.map((each) => this.material(each))
      : this.material(mesh.material);
    const skinned = copy as SkinnedMesh;
    if (skinned.isSkinnedMesh) {
      const { bones, boneInverses } = skinned.skeleton;
      skinned.skeleton = new Skeleton(bones, boneInverses);
    }
    const instances = copy as InstancedMesh;
    if (instances.isInstancedMesh) {
      instances.instanceMatrix = (source as InstancedMesh).instanceMatrix;
      this.instanced.push(instances);
    }
    return copy;
  }

  background(source: Color | Texture | null): Color | Texture | null {
    if (source instanceof Texture) return this.texture(source);
    return source ? source.clone() : null;
  }

  /** Sets the shading of all copied materials: any for Farol, flat or smooth for three's own renderers. */
  shade(shading: ShadingName): void {
    for (const material of this.materials.values()) {
      setShading(material, shading);
      if ('flatShading' in material) material.flatShading = shading === 'flat';
    }
  }

  /** Frees the GPU resources of the copies. */
  dispose(): void {
    for (const each of [...this.geometries.values(), ...this.materials.values(), ...this.textures.values()])
      each.dispose();
    for (const each of this.instanced) each.dispose();
  }

  texture(source: Texture): Texture {
    if (source.isRenderTargetTexture) return source;
    return copyOnce(this.textures, source, () => source.clone());
  }

  private geometry(source: BufferGeometry): BufferGeometry {
    return copyOnce(this.geometries, source, () => {
      if ('isInstancedBufferGeometry' in source) return source.clone();
      const { attributes, index, morphAttributes, morphTargetsRelative, groups, drawRange } = source;
      const copy = new BufferGeometry();
      Object.assign(copy, { attributes: { ...attributes }, index, morphAttributes, morphTargetsRelative });
      Object.assign(copy, { groups, drawRange, name: source.name });
      copy.boundingBox = source.boundingBox;
      copy.boundingSphere = source.boundingSphere;
      return copy;
    });
  }

  private material(source: Material): Material {
    return copyOnce(this.materials, source, () => {
      const copy = source.clone();
      copy.onBeforeCompile = source.onBeforeCompile;
      copy.customProgramCacheKey = source.customProgramCacheKey;
      const values = copy as unknown as Record<string, unknown>;
      for (const [name, value] of Object.entries(values)) {
        if (value instanceof Texture) values[name] = this.texture(value);
      }
      const { uniforms } = copy as { uniforms?: Record<string, { value: unknown }> };
      for (const uniform of Object.values(uniforms ?? {})) {
        if (uniform.value instanceof Texture) uniform.value = this.texture(uniform.value);
      }
      return copy;
    });
  }
}

function copyOnce<T>(copies: Map<T, T>, source: T, make: () => T): T {
  let copy = copies.get(source);
  if (copy === undefined) copies.set(source, (copy = make()));
  return copy;
}
