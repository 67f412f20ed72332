import type { Vector3Tuple } from '@farol/engine/fields';
import { addCamera, iron, light, mesh, wood } from './parts';
import { SampleScene } from './SampleScene';

const warm: Vector3Tuple = [1, 0.72, 0.4];

function lampPrefab(scene: SampleScene): string {
  return scene.prefab('Street lamp', () => {
    const lamp = scene.object('Street lamp', {});
    scene.object('Foot', { position: [0, 0.15, 0], scale: [0.36, 0.3, 0.36], parent: lamp }, mesh('cylinder', iron));
    scene.object('Post', { position: [0, 1.7, 0], scale: [0.12, 3.4, 0.12], parent: lamp }, mesh('cylinder', iron));
    const head = scene.object('Head', { position: [0, 3.55, 0], parent: lamp });
    scene.object('Hat', { position: [0, 0.3, 0], scale: [0.62, 0.28, 0.62], parent: head }, mesh('cone', iron));
    scene.object('Glass', { scale: [0.34, 0.36, 0.34], parent: head }, [
      'ObjectRenderer',
      { mesh: 'sphere', colour: [0.2, 0.17, 0.12], emissive: warm, emissiveIntensity: 4 },
    ]);
    scene.object(
      'Bulb',
      { position: [0, 0.1, 0], rotation: [-Math.PI / 2, 0, 0], parent: head },
      light('spot', { diffuse: warm, intensity: 60, range: 9, cutoff: 1.15, penumbra: 0.7, shadowMapSize: 512 }),
    );
    return lamp;
  });
}

function benchPrefab(scene: SampleScene): string {
  return scene.prefab('Bench', () => {
    const bench = scene.object('Bench', {});
    const board = { ...wood, repeat: 0.5 };
    for (const [i, z] of [-0.14, 0, 0.14].entries()) {
      const place = { position: [0, 0.45, z], scale: [1.5, 0.04, 0.12], parent: bench } as const;
      scene.object(`Seat ${i + 1}`, place, mesh('box', board));
    }
    const back = { position: [0, 0.75, -0.24], rotation: [-0.15, 0, 0], scale: [1.5, 0.28, 0.04] } as const;
    scene.object('Back', { ...back, parent: bench }, mesh('box', board));
    for (const x of [-0.6, 0.6]) {
      const place = { position: [x, 0.22, -0.02], scale: [0.06, 0.44, 0.42], parent: bench } as const;
      scene.object(x < 0 ? 'Left leg' : 'Right leg', place, mesh('box', iron));
    }
    return bench;
  });
}

function treePrefab(scene: SampleScene): string {
  return scene.prefab('Tree', () => {
    const tree = scene.object('Tree', {});
    const bark = { colour: [0.23, 0.15, 0.09], roughness: 0.95 } as const;
    const leaf = { colour: [0.07, 0.2, 0.09], roughness: 0.85 } as const;
    scene.object('Trunk', { position: [0, 0.6, 0], scale: [0.28, 1.2, 0.28], parent: tree }, mesh('cylinder', bark));
    scene.object('Lower leaves', { position: [0, 1.9, 0], scale: [2, 1.8, 2], parent: tree }, mesh('cone', leaf));
    scene.object('Upper leaves', { position: [0, 2.9, 0], scale: [1.4, 1.6, 1.4], parent: tree }, mesh('cone', leaf));
    return tree;
  });
}

/** A prefab made of two others: a lamp beside a bench. */
function placePrefab(scene: SampleScene, lamp: string, bench: string): string {
  return scene.prefab('Resting place', () => {
    const place = scene.object('Resting place', {});
    scene.instance(lamp, { position: [1.15, 0, -0.2], parent: place });
    scene.instance(bench, { parent: place });
    return place;
  });
}

/** A street at dusk made of four prefabs, one of them containing two others. */
export async function prefabs(): Promise<SampleScene> {
  const scene = new SampleScene('Prefabs');
  Object.assign(scene.settings, {
    ...{
      background: 'gradient',
      skyTop: [0.01, 0.02, 0.06],
      skyHorizon: [0.12, 0.08, 0.1],
      skyGround: [0.01, 0.01, 0.01],
    },
    ...{ toneMapping: 'agx', exposure: 1.4, bloom: true, bloomIntensity: 0.5, bloomThreshold: 1.2 },
    ...{ fog: 'exponential', fogFromSky: true, fogDensity: 0.018, vignette: true, vignetteDarkness: 0.4 },
  });
  addCamera(scene, [4.6, 2.1, 9.4], [-0.6, 1.5, -2], { fov: 0.9 });
  const ground = { scale: [60, 1, 60] } as const;
  const grass = {
    map: 'grass',
    normalMap: 'grass-normal',
    colour: [0.5, 0.6, 0.45],
    repeat: 30,
    roughness: 0.95,
  } as const;
  scene.object('Ground', ground, mesh('plane', grass));
  const paving = {
    map: 'tiles',
    normalMap: 'tiles-normal',
    colour: [0.6, 0.58, 0.55],
    repeat: 1,
    roughness: 0.5,
  } as const;
  const road = scene.object('Road', {});
  for (let i = 0; i < 12; i++) {
    const place = { position: [0, 0.02, 8 - i * 3], scale: [3, 0.04, 3], parent: road } as const;
    scene.object('Slab', place, mesh('box', paving));
  }
  scene.object(
    'Moon',
    { position: [-8, 14, 4], target: [0, 0, 0] },
    light('directional', { diffuse: [0.5, 0.62, 1], intensity: 0.35, shadowExtent: 16 }),
  );
  const lamp = lampPrefab(scene);
  const bench = benchPrefab(scene);
  const tree = treePrefab(scene);
  const rest = placePrefab(scene, lamp, bench);
  const street = scene.object('Street', {});
  for (let i = 0; i < 4; i++) {
    const z = 5 - i * 6;
    scene.instance(rest, { position: [-2.6, 0, z], rotation: [0, Math.PI / 2, 0], parent: street });
    scene.instance(lamp, { position: [2.3, 0, z - 3], parent: street });
  }
  // an instance with overrides, which the inspector shows in bold
  const violet = { 'Bulb/Light.diffuse': [0.75, 0.45, 1], 'Glass/ObjectRenderer.emissive': [0.75, 0.45, 1] } as const;
  scene.instance(lamp, { position: [2.3, 0, 5], parent: street }, violet, 'Violet lamp');
  const wood3 = scene.object('Trees', {});
  for (let i = 0; i < 14; i++) {
    const side = i % 2 === 0 ? -1 : 1;
    const far = 5.2 + ((i * 7) % 5) * 1.1;
    const size = 0.9 + ((i * 5) % 7) * 0.12;
    scene.instance(tree, {
      position: [side * far, 0, 4 - i * 2],
      rotation: [0, i * 1.3, 0],
      scale: [size, size, size],
      parent: wood3,
    });
  }
  return scene;
}
