import {
  type BufferGeometry,
  type Camera,
  type Color,
  type InstancedMesh,
  type Light,
  MathUtils,
  type Material,
  type Mesh,
  type Object3D,
  type PerspectiveCamera,
  SRGBColorSpace,
  type Texture,
} from 'three';
import type { StageScene } from '../../stage/StageScene';
import { describeGeometry } from './describeGeometry';
import { describePoints, describeStillLights } from './describeLights';
import { describeMaterial } from './describeMaterial';
import { describeTexture } from './describeTexture';
import { placementOf } from './placementOf';
import type { Rgb, RivalCamera, RivalInstances, RivalMaterial, RivalMesh, RivalScene } from './RivalScene';

/** A list of values without duplicates: one value is made for each key. */
class Indexed<K, V> {
  readonly values: V[] = [];
  private readonly indices = new Map<K, number>();

  indexOf(key: K, make: () => V): number {
    let index = this.indices.get(key);
    if (index === undefined) {
      index = this.values.push(make()) - 1;
      this.indices.set(key, index);
    }
    return index;
  }
}

function describeCamera(camera: Camera): RivalCamera {
  const of = camera as PerspectiveCamera;
  if (!of.isPerspectiveCamera || of.view?.enabled || of.zoom !== 1 || of.filmOffset !== 0) {
    throw new Error('The camera is not a plain PerspectiveCamera: other engines get only that.');
  }
  camera.updateWorldMatrix(true, false);
  return {
    fov: of.fov * MathUtils.DEG2RAD,
    near: of.near,
    far: of.far,
    placement: placementOf(camera),
  };
}

function describeBackground(background: StageScene['three']['background']): Rgb | null {
  if (background === null) return null;
  if (!(background as Color).isColor) throw new Error('The background is a texture: other engines get only colours.');
  const { r, g, b } = (background as Color).getRGB({ r: 0, g: 0, b: 0 } as Color, SRGBColorSpace);
  return [r, g, b];
}

/** Visible meshes of the scene, sorted by `renderOrder`. */
function meshesOf({ three, camera }: StageScene): Mesh[] {
  const meshes: Mesh[] = [];
  three.traverseVisible((object: Object3D) => {
    const kind = object as Mesh & { isSkinnedMesh?: boolean; isBatchedMesh?: boolean };
    const isOther = 'isLine' in object || 'isPoints' in object || 'isSprite' in object || kind.isBatchedMesh;
    if (isOther || kind.isSkinnedMesh) {
      throw new Error(`${object.name || 'An object'} is a ${object.type}: the Lab cannot give it to other engines.`);
    }
    if (kind.isMesh && object.layers.test(camera.layers)) meshes.push(kind);
  });
  return meshes.sort((a, b) => a.renderOrder - b.renderOrder);
}

/** Checks that `lights` and `still` contain every visible light: otherwise an engine would draw fewer lights. */
function checkLights({ three, lights, still }: StageScene): void {
  const named = new Set<Object3D>([...lights, ...still]);
  three.traverseVisible((object) => {
    if ((object as Light).isLight && !named.has(object)) {
      throw new Error(`Light ${object.name || 'without a name'} cannot be given to other engines.`);
    }
  });
}

function describeInstances(mesh: Mesh): RivalInstances | null {
  const instanced = mesh as InstancedMesh;
  if (!instanced.isInstancedMesh) return null;
  const { count, instanceMatrix, instanceColor } = instanced;
  return {
    count,
    matrices: instanceMatrix.array as Float32Array,
    colours: instanceColor ? new Float32Array(instanceColor.array).subarray(0, count * 3) : null,
  };
}

/** A scene as plain data, and the meshes of three that it was made of. */
export interface Described {
  readonly scene: RivalScene;
  /** Source mesh of each mesh in `scene.meshes`, by index. */
  readonly sources: readonly Mesh[];
}

/**
 * Converts a case's scene to plain data for another engine.
 * @throws Error naming a property that the Lab does not convert: nothing is left out silently
 */
export function describeScene(stageScene: StageScene): Described {
  const { three, camera, lights, still, width, height } = stageScene;
  if (three.fog) throw new Error('The scene has fog: other engines do not get it.');
  if (three.environment) throw new Error('The scene has an environment map: other engines do not get it.');
  if (three.overrideMaterial) throw new Error('The scene has an override material: other engines do not get it.');
  checkLights(stageScene);
  three.updateMatrixWorld();
  const textures = new Indexed<Texture, ReturnType<typeof describeTexture>>();
  const materials = new Indexed<Material, RivalMaterial>();
  const geometries = new Map<BufferGeometry, Map<string, number>>();
  const geometryList: RivalScene['geometries'][number][] = [];
  const textureIndex = (texture: Texture): number => textures.indexOf(texture, () => describeTexture(texture));
  const geometryIndex = (
    geometry: BufferGeometry,
    part: { start: number; count: number } | null,
    isFlat: boolean,
  ): number => {
    const key = `${part ? `${part.start} ${part.count}` : 'all'} ${isFlat}`;
    let parts = geometries.get(geometry);
    if (!parts) geometries.set(geometry, (parts = new Map()));
    let index = parts.get(key);
    if (index === undefined) {
      index = geometryList.push(describeGeometry(geometry, part, isFlat)) - 1;
      parts.set(key, index);
    }
    return index;
  };
  const meshes: RivalMesh[] = [];
  const sources: Mesh[] = [];
  for (const mesh of meshesOf(stageScene)) {
    const { material: materialOrList, geometry } = mesh as Mesh<BufferGeometry, Material | Material[]>;
    const groups = Array.isArray(materialOrList)
      ? geometry.groups.map((group) => ({ material: materialOrList[group.materialIndex ?? 0], part: group }))
      : [{ material: materialOrList, part: null }];
    for (const { material, part } of groups) {
      if (!material?.visible) continue;
      const isFlat = (material as { flatShading?: boolean }).flatShading === true;
      sources.push(mesh);
      meshes.push({
        geometry: geometryIndex(geometry, part, isFlat),
        material: materials.indexOf(material, () => describeMaterial(material, textureIndex)),
        placement: placementOf(mesh),
        instances: describeInstances(mesh),
      });
    }
  }
  const scene: RivalScene = {
    width,
    height,
    camera: describeCamera(camera),
    background: describeBackground(three.background),
    ...describeStillLights(still.filter((light) => light.visible)),
    points: describePoints(lights),
    textures: textures.values,
    materials: materials.values,
    geometries: geometryList,
    meshes,
    isOrdered: sources.some(({ renderOrder }) => renderOrder !== 0),
  };
  return { scene, sources };
}
