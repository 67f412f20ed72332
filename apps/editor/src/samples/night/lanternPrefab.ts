import { iron, mesh } from '../parts';
import type { SampleScene } from '../SampleScene';

const warm = [1, 0.62, 0.28] as const;

/** A lantern on a chain, swinging from a joint at its top. Its origin is the hook. */
export function lanternPrefab(scene: SampleScene): string {
  return scene.prefab('Lantern', () => {
    const lantern = scene.object('Lantern', {});
    const body = scene.object(
      'Body',
      { position: [0, -2.3, 0], parent: lantern },
      ['RigidBody', { mass: 4, angularDamping: 0, initialVelocity: [0.7, 0, 0.4] }],
      ['Collider', { shape: 'cylinder', fit: false, size: [0.4, 0.66, 0.4] }],
      ['Joint', { type: 'ball', anchor: [0, 2.3, 0] }],
    );
    scene.object('Chain', { position: [0, 1.25, 0], scale: [0.03, 2.1, 0.03], parent: body }, mesh('cylinder', iron));
    scene.object('Hat', { position: [0, 0.28, 0], scale: [0.5, 0.24, 0.5], parent: body }, mesh('cone', iron));
    scene.object('Base', { position: [0, -0.24, 0], scale: [0.36, 0.06, 0.36], parent: body }, mesh('cylinder', iron));
    for (const [x, z] of [
      [-0.13, -0.13],
      [0.13, -0.13],
      [-0.13, 0.13],
      [0.13, 0.13],
    ] as const) {
      const place = { position: [x, -0.03, z], scale: [0.025, 0.4, 0.025], parent: body } as const;
      scene.object('Bar', place, mesh('box', iron));
    }
    const glass = { colour: [0.2, 0.12, 0.05], emissive: warm, emissiveIntensity: 6 } as const;
    scene.object(
      'Flame',
      { scale: [0.17, 0.24, 0.17], parent: body },
      ['ObjectRenderer', { mesh: 'sphere', ...glass }],
      ['Light', { diffuse: warm, intensity: 13, range: 8, shadowMapSize: 512, shadowRadius: 2 }],
    );
    return lantern;
  });
}
