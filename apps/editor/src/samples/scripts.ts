import type { Vector3Tuple } from '@farol/engine/fields';
import { Color } from 'three';
import { addCamera, light, mesh, stone } from './parts';
import { SampleScene } from './SampleScene';

/** Texts of the scripts in the folder `scripts`, which are linted and type-checked with the editor. */
const sources: Readonly<Record<string, string>> = import.meta.glob('./scripts/*.ts', {
  eager: true,
  query: '?raw',
  import: 'default',
});

/**
 * Four scripts, one imported by another: a wave through 121 columns, circling lights that change colour, a fountain.
 */
export async function scripts(): Promise<SampleScene> {
  const scene = new SampleScene('Scripts');
  for (const [path, source] of Object.entries(sources))
    scene.asset('script', path.replace('./scripts/', '').replace(/\.ts$/, ''), { source });
  Object.assign(scene.settings, {
    ...{
      background: 'gradient',
      skyTop: [0.008, 0.012, 0.03],
      skyHorizon: [0.05, 0.05, 0.09],
      skyGround: [0.01, 0.01, 0.02],
    },
    ...{ toneMapping: 'aces-filmic', exposure: 1.1, bloom: true, bloomIntensity: 0.6, bloomThreshold: 1 },
  });
  addCamera(scene, [5.4, 5.6, 9], [0, 0.4, 0.2], { fov: 0.85 });
  scene.object(
    'Moon',
    { position: [-6, 9, 5], target: [0, 0, 0] },
    light('directional', { diffuse: [0.55, 0.65, 1], intensity: 0.5, shadowExtent: 9 }),
  );
  scene.object(
    'Ground',
    { position: [0, -0.02, 0], scale: [30, 1, 30] },
    mesh('plane', { colour: [0.16, 0.16, 0.2], roughness: 0.5 }),
  );
  const columns = scene.object('Columns', {}, ['Wave', { height: 0.9 }]);
  for (let row = -5; row <= 5; row++) {
    for (let column = -5; column <= 5; column++) {
      if (Math.hypot(row, column) < 1.5) continue;
      const place = { position: [column * 0.8, -0.3, row * 0.8], scale: [0.56, 1.2, 0.56], parent: columns } as const;
      scene.object('Column', place, mesh('box', { ...stone, repeat: 0.5, colour: [0.8, 0.8, 0.86], roughness: 0.4 }));
    }
  }
  scene.object('Fountain', { position: [0, 0.3, 0] }, mesh('cylinder', { ...stone, repeat: 1 }), ['Fountain']);
  const lights = scene.object('Lights', {});
  for (let i = 0; i < 12; i++) {
    const far = 1.6 + i * 0.28;
    const place = { position: [Math.cos(i * 1.7) * far, 1.5 + (i % 3) * 0.35, Math.sin(i * 1.7) * far] } as const;
    const { r, g, b } = new Color().setHSL(i / 12, 1, 0.5);
    const colour: Vector3Tuple = [r, g, b];
    scene.object(
      'Light',
      { ...place, parent: lights },
      [
        'Light',
        { diffuse: colour, intensity: 5, range: 3.5, ...(i % 6 === 0 && { castShadow: true, shadowMapSize: 512 }) },
      ],
      ['ObjectRenderer', { mesh: 'bulb', kind: 'basic', instanced: true, colour }],
      ['Orbit', { speed: (i % 2 === 0 ? 1 : -1) * (1.1 - i * 0.05) }],
      ['Rainbow', { hue: i / 12 }],
    );
  }
  return scene;
}
