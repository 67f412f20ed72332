import { mesh, wood } from '../parts';
import type { SampleScene } from '../SampleScene';

/** The door of the inner room: two leaves. @param floor - height of the floor (m) */
export function addDoor(scene: SampleScene, floor: number): void {
  const door = scene.object('Door', { position: [0, floor, 6.45] });
  const planks = { ...wood, colour: [0.5, 0.33, 0.2], repeat: 1 } as const;
  const bronze = { colour: [0.5, 0.34, 0.17], roughness: 0.35, metalness: 0.9 } as const;
  for (const side of [-1, 1] as const) {
    const leaf = scene.object(side < 0 ? 'Left leaf' : 'Right leaf', { position: [side * 1.5, 0, 0], parent: door });
    const panel = { position: [-side * 0.745, 2.2, 0], scale: [1.48, 4.36, 0.12], parent: leaf } as const;
    scene.object('Panel', panel, mesh('box', planks));
    for (const y of [0.5, 2.2, 3.9]) {
      const place = { position: [-side * 0.745, y, 0], scale: [1.44, 0.12, 0.17], parent: leaf } as const;
      scene.object('Band', place, mesh('box', bronze));
    }
    const ring = { position: [-side * 1.3, 1.35, 0.13], scale: [0.22, 0.22, 0.22], parent: leaf } as const;
    scene.object('Ring', ring, mesh('torus', bronze));
  }
}
