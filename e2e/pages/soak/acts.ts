import { type TechniqueName, techniques, views } from '@farol/renderer';
import * as THREE from 'three';
import type { Soak } from './Soak';
import { casters, soakScenes } from './soakScenes';

/** Message that is thrown on purpose. */
export const THROWN = 'thrown by the soak';

const fail = (): never => {
  throw new Error(THROWN);
};

const pick = <T>(soak: Soak, list: readonly T[]): T => list[Math.floor(soak.random() * list.length)];

const meshesOf = (soak: Soak): THREE.Mesh[] => {
  const meshes: THREE.Mesh[] = [];
  soak.scene.traverse((object) => object instanceof THREE.Mesh && meshes.push(object));
  return meshes;
};

/** Makes callbacks throw for some frames, one after another or many at once. */
function exceptions(soak: Soak): string {
  const mesh = pick(soak, meshesOf(soak));
  const [material] = [mesh.material].flat();
  const { scene } = soak;
  const callback = pick(soak, ['object', 'objectAfter', 'scene', 'sceneAfter', 'compile', 'material'] as const);
  const undo = {
    object: () => Reflect.deleteProperty(mesh, 'onBeforeRender'),
    objectAfter: () => Reflect.deleteProperty(mesh, 'onAfterRender'),
    scene: () => Reflect.deleteProperty(scene, 'onBeforeRender'),
    sceneAfter: () => Reflect.deleteProperty(scene, 'onAfterRender'),
    compile: () => {
      Reflect.deleteProperty(material, 'onBeforeCompile');
      Reflect.deleteProperty(material, 'customProgramCacheKey');
      material.needsUpdate = true;
    },
    material: () => Reflect.deleteProperty(material, 'onBeforeRender'),
  }[callback];
  if (callback === 'object') mesh.onBeforeRender = fail;
  else if (callback === 'objectAfter') mesh.onAfterRender = fail;
  else if (callback === 'scene') scene.onBeforeRender = fail;
  else if (callback === 'sceneAfter') scene.onAfterRender = fail;
  else if (callback === 'material') material.onBeforeRender = fail;
  else {
    material.onBeforeCompile = fail;
    material.customProgramCacheKey = () => `soak ${soak.count}`;
    material.needsUpdate = true;
  }
  for (let i = Math.floor(soak.random() * 6); i >= 0; i--) soak.draw();
  undo();
  return `${callback} of ${mesh.name || mesh.type}`;
}

/** A light more, or one less. */
function lights(soak: Soak): string {
  const { scene, added } = soak;
  if (added.length > 0 && soak.random() < 0.5) {
    const [light] = added.splice(Math.floor(soak.random() * added.length), 1);
    light.removeFromParent();
    light.dispose();
    return 'less';
  }
  const colour = new THREE.Color().setHSL(soak.random(), 0.8, 0.6);
  const light = soak.random() < 0.6 ? new THREE.PointLight(colour, 8, 4) : new THREE.SpotLight(colour, 20, 9, 0.6, 0.3);
  light.position.set((soak.random() - 0.5) * 8, soak.random() * 4, soak.random() * 4);
  scene.add(light);
  added.push(light);
  return `more: ${light.type}`;
}

function shadows(soak: Soak): string {
  if (soak.random() < 0.2) {
    soak.shadowType = pick(soak, [THREE.BasicShadowMap, THREE.PCFShadowMap, THREE.VSMShadowMap]);
    return `type ${soak.shadowType}`;
  }
  const list = casters(soak.scene);
  if (list.length === 0) return 'no light';
  const light = pick(soak, list);
  light.castShadow = !light.castShadow;
  light.shadow.mapSize.set(64, 64);
  light.shadow.needsUpdate = true;
  return `${light.type} ${light.castShadow}`;
}

/** A texture that does not load, in place of a map. */
async function texture(soak: Soak): Promise<string> {
  const candidates = meshesOf(soak).filter(
    ({ material }) => [material].flat()[0] instanceof THREE.MeshStandardMaterial,
  );
  if (candidates.length === 0) return 'no material';
  const [material] = [pick(soak, candidates).material].flat() as THREE.MeshStandardMaterial[];
  const before = material.map;
  const failed = await new Promise<THREE.Texture>((resolve) => {
    const made: THREE.Texture = new THREE.TextureLoader().load('data:image/png;base64,AAAA', resolve, undefined, () =>
      resolve(made),
    );
  });
  material.map = failed;
  material.needsUpdate = true;
  soak.draw();
  soak.draw();
  material.map = before;
  material.needsUpdate = true;
  failed.dispose();
  return material.type;
}

/** Everything that the soak does to a renderer, by a name that switches it off. */
export const acts = {
  loss: async (soak: Soak) => soak.loseContext(),
  exception: exceptions,
  technique: (soak: Soak) => {
    soak.farol.technique = pick(soak, Object.keys(techniques) as TechniqueName[]);
    soak.applyEffects();
    return soak.farol.technique;
  },
  view: (soak: Soak) => {
    soak.farol.view = pick(soak, views);
    soak.draw();
    soak.draw();
    soak.farol.view = 'final';
    return '';
  },
  effects: (soak: Soak) => soak.chooseEffects(),
  scene: (soak: Soak) => soak.openScene(pick(soak, Object.keys(soakScenes)), soak.random() < 0.25),
  size: (soak: Soak) => soak.resize(96 + 16 * Math.floor(soak.random() * 5), 64 + 16 * Math.floor(soak.random() * 3)),
  shadows,
  cascades: (soak: Soak) => {
    soak.farol.shadowCascades = soak.random() < 0.5 ? 1 : 3;
    return String(soak.farol.shadowCascades);
  },
  lights,
  layers: (soak: Soak) => {
    soak.farol.lightLayers = !soak.farol.lightLayers;
    return String(soak.farol.lightLayers);
  },
  camera: (soak: Soak) => {
    soak.camera.position.x += soak.random() - 0.5;
    soak.camera.position.y += (soak.random() - 0.5) * 0.4;
    return '';
  },
  texture,
} as const satisfies Record<string, (soak: Soak) => string | Promise<string>>;

export type ActName = keyof typeof acts;
