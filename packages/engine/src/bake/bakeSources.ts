import type { Mesh, Object3D } from 'three';
import { Light } from '../components/Light';
import { ModelRenderer } from '../components/ModelRenderer';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { gameObjectOf } from '../core/gameObjectOf';
import type { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';
import { takesLightmap } from '../core/baked/lightmappedMaterial';

/** Meshes, lights and sky of a scene that take part in a bake. */
export interface BakeSources {
  /** Meshes that get a lightmap. */
  readonly meshes: readonly BakeMesh[];
  /** GameObjects that draw `meshes`. */
  readonly objects: readonly GameObject[];
  /** Static objects that are drawn, but not as meshes of their own: probes light them. */
  readonly instanced: readonly GameObject[];
  /** Lights that are baked, whole or in part. */
  readonly lights: readonly Light[];
}

/** A mesh that gets a lightmap. */
export interface BakeMesh {
  readonly mesh: Mesh;
  /** Renderer of the mesh, and the mesh's index in it: see `LightmappedMesh`. */
  readonly component: ObjectRenderer | ModelRenderer;
  readonly part: number;
}

type MeshLike = Mesh & { readonly isSkinnedMesh?: boolean; readonly isInstancedMesh?: boolean };

/** Whether a mesh can have a lightmap: a skinned, morphed or instanced mesh has no fixed light for a texel. */
function canBeLightmapped(mesh: MeshLike): boolean {
  const { geometry, material } = mesh;
  const materials = Array.isArray(material) ? material : [material];
  return (
    mesh.isSkinnedMesh !== true &&
    mesh.isInstancedMesh !== true &&
    Object.keys(geometry.morphAttributes).length === 0 &&
    materials.every((each) => takesLightmap(each) && !each.transparent)
  );
}

function meshesOf(component: ObjectRenderer | ModelRenderer): BakeMesh[] {
  const found: BakeMesh[] = [];
  let part = 0;
  component.three?.traverse((object: Object3D) => {
    if (!('isMesh' in object)) return;
    const mesh = object as MeshLike;
    if (mesh.visible && canBeLightmapped(mesh)) found.push({ mesh, component, part });
    part++;
  });
  return found;
}

/** Collects the sources of a bake from the scene's present state. */
export function bakeSources(scene: Scene): BakeSources {
  const renderers = [...scene.componentsOf(ObjectRenderer), ...scene.componentsOf(ModelRenderer)].filter(
    (component) => component.isActive && component.gameObject.isStatic,
  );
  const meshes = renderers.flatMap(meshesOf);
  const instanced = renderers
    .filter((component) => component instanceof ObjectRenderer && component.instanced)
    .map(({ gameObject }) => gameObject);
  const objects = [...new Set(meshes.map(({ component }) => component.gameObject))];
  const lights = scene.componentsOf(Light).filter((light) => light.isActive && light.mode !== 'realtime');
  return { meshes, objects, instanced, lights };
}

/**
 * Whether a skinned or instanced mesh, which gets no lightmap, casts shadows and reflects light in a bake: it does when
 * it belongs to a static object.
 * @param instance - index of an instance to test; without it, an instanced mesh as a whole counts as static
 */
export function isStaticWithoutLightmap(object: Object3D, instance?: number): boolean {
  const { isSkinnedMesh, isInstancedMesh } = object as MeshLike;
  if (isInstancedMesh && instance === undefined) return true;
  return (isSkinnedMesh || isInstancedMesh) === true && gameObjectOf(object, instance)?.isStatic === true;
}
