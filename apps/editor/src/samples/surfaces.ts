import { dissolveText, hologramText, rustText, wavesText } from './surfaceTexts';
import { addCamera, light, mesh } from './parts';
import { SampleScene } from './SampleScene';

/** Four objects with surfaces made of microshaders, among a few lights. */
export async function surfaces(): Promise<SampleScene> {
  const scene = new SampleScene('Surfaces');
  Object.assign(scene.settings, {
    ...{ backgroundColour: [0.012, 0.014, 0.022], toneMapping: 'aces-filmic', exposure: 1 },
    ...{ bloom: true, bloomIntensity: 0.4, bloomThreshold: 1.2 },
  });
  scene.asset('surface', 'Waves', { source: wavesText });
  scene.asset('surface', 'Dissolve', { source: dissolveText });
  scene.asset('surface', 'Rust', { source: rustText });
  scene.asset('surface', 'Hologram', { source: hologramText });
  scene.asset('material', 'Sea', {
    ...{ kind: 'physical', colour: [0.02, 0.12, 0.2], roughness: 0.15, surface: 'Waves' },
    surfaceValues: '{"height":0.03,"wavelength":0.4}',
  });
  scene.asset('material', 'Ember', {
    ...{ kind: 'standard', colour: [0.35, 0.35, 0.38], doubleSided: true, surface: 'Dissolve' },
    surfaceValues: '{"size":0.16}',
  });
  scene.asset('material', 'Old paint', {
    ...{ kind: 'standard', colour: [0.05, 0.25, 0.3], roughness: 0.35, metalness: 0.6, surface: 'Rust' },
  });
  scene.asset('material', 'Projection', {
    ...{ kind: 'standard', transparent: true, depthWrite: false, doubleSided: true, surface: 'Hologram' },
  });
  addCamera(scene, [0, 2.3, 6.6], [0, 0.75, 0], { fov: 0.75 });
  scene.object('Sky', { position: [0, 6, 0] }, [
    'Light',
    { type: 'hemisphere', diffuse: [0.5, 0.6, 0.8], groundColour: [0.2, 0.17, 0.15], intensity: 0.35 },
  ]);
  scene.object('Floor', { scale: [14, 1, 14] }, mesh('plane', { colour: [0.35, 0.36, 0.4], roughness: 0.8 }));
  const stands = [-2.7, -0.9, 0.9, 2.7];
  for (const x of stands)
    scene.object(
      'Stand',
      { position: [x, 0.1, 0], scale: [1.3, 0.2, 1.3] },
      mesh('cylinder', { colour: [0.2, 0.2, 0.22] }),
    );
  scene.object(
    'Planet',
    { position: [stands[0], 0.85, 0], scale: [1.2, 1.2, 1.2] },
    mesh('sphere', { material: 'Sea' }),
  );
  scene.object(
    'Statue',
    { position: [stands[1], 0.2, 0], rotation: [0, 0.9, 0], scale: [1.5, 1.5, 1.5] },
    mesh('dragon', { material: 'Ember' }),
  );
  scene.object(
    'Crate',
    { position: [stands[2], 0.65, 0], rotation: [0, 0.6, 0], scale: [0.9, 0.9, 0.9] },
    mesh('box', { material: 'Old paint' }),
  );
  scene.object(
    'Ring',
    { position: [stands[3], 0.95, 0], rotation: [0.3, 0.4, 0], scale: [1.3, 1.3, 1.3] },
    mesh('torus', { material: 'Projection', castShadow: false }),
  );
  scene.object(
    'Key',
    { position: [-2.5, 4.5, 3.5], target: [0, 0.4, 0] },
    light('spot', { diffuse: [1, 0.93, 0.82], intensity: 120, range: 14, cutoff: 0.8 }),
  );
  for (const [x, diffuse] of [
    [-4, [0.3, 0.5, 1]],
    [4, [1, 0.4, 0.25]],
  ] as const)
    scene.object(
      'Light',
      { position: [x, 1.6, 1.4] },
      ['Light', { diffuse: [...diffuse], intensity: 9, range: 6 }],
      ['RandomMovement', { seed: 7, extent: [0.8, 0.3, 0.8], speed: 0.5 }],
    );
  return scene;
}
