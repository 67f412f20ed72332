import type { FieldValue } from '@farol/editing/fields';
import type { GameObject } from '@farol/engine';
import { textureName } from '@farol/engine/builders';
import type { SceneBuilder } from '../SceneBuilder';
import { registerMeshes } from '../registerMeshes';
import { atriumMeshes } from './atriumMeshes';
import { atriumPlan, bayWidth } from './atriumPlan';

type Look = Readonly<Record<string, FieldValue>>;

const { length, bays, nave, outer, storey, thickness, upperSpring } = atriumPlan;

function looksFor(textureSize: number): Record<string, Look> {
  const textured = (name: string, repeat: number, roughness: number): Look => ({
    map: textureName(name, textureSize),
    normalMap: textureName(`${name}-normal`, textureSize),
    colour: [0.92, 0.92, 0.92],
    repeat,
    roughness,
    castShadow: true,
    receiveShadow: true,
  });
  return {
    marble: textured('marble', 0.6, 0.55),
    stone: textured('stone', 0.25, 0.8),
    plaster: textured('plaster', 0.4, 0.85),
    brick: textured('brick', 0.3, 0.9),
    floor: textured('tiles', 0.25, 0.4),
    wood: textured('wood', 0.5, 0.7),
    red: textured('cloth-red', 1, 0.95),
    green: textured('cloth-green', 1, 0.95),
    blue: textured('cloth-blue', 1, 0.95),
    terracotta: { ...textured('plaster', 1, 0.75), colour: [0.62, 0.3, 0.18] },
    leaf: { colour: [0.1, 0.26, 0.06], roughness: 0.6, castShadow: true, receiveShadow: true },
    bronze: { colour: [0.5, 0.34, 0.17], roughness: 0.35, metalness: 0.9 },
  };
}

/** Adds the atrium's 100-odd meshes to the scene. */
export function addAtrium(build: SceneBuilder, textureSize: number): void {
  registerMeshes(build.scene.assets, atriumMeshes);
  const looks = looksFor(textureSize);
  const atrium = build.group('Atrium');
  build.mesh('Floor', 'sponza/floor', looks.floor, { parent: atrium });
  for (const side of [1, -1]) addLongSide(build, atrium, looks, side);
  for (const end of [1, -1]) {
    const place = { position: [(end * length) / 2, 0, 0], rotation: [0, (-end * Math.PI) / 2, 0] } as const;
    build.mesh('End wall', 'sponza/end-wall', looks.brick, { ...place, parent: atrium });
  }
  addFurniture(build, looks);
}

/** Adds one long side, with its arcades towards the nave. Side 1 is at +z. */
function addLongSide(build: SceneBuilder, atrium: GameObject, looks: Record<string, Look>, side: number): void {
  const group = build.object(side > 0 ? 'South side' : 'North side', {
    rotation: [0, side > 0 ? Math.PI : 0, 0],
    parent: atrium,
  });
  const parent = group;
  const edge = -nave + thickness;
  build.mesh('Wall', 'sponza/long-wall', looks.brick, { position: [0, 0, -outer], parent });
  build.mesh('Gallery', 'sponza/gallery', looks.plaster, { position: [0, storey, edge], parent });
  build.mesh('Vault', 'sponza/vault', looks.plaster, { position: [0, 0, -nave], parent });
  build.mesh('Roof', 'sponza/roof', looks.wood, { position: [0, 2 * storey, edge], parent });
  build.mesh('Cornice', 'sponza/cornice', looks.stone, { position: [0, 2 * storey, -nave], parent });
  for (let i = 0; i <= bays; i++) {
    const x = i * bayWidth - length / 2;
    const inset = i === 0 ? 0.4 : i === bays ? -0.4 : 0;
    build.mesh('Lower column', 'sponza/lower-column', looks.marble, { position: [x + inset, 0, -nave], parent });
    build.mesh('Upper column', 'sponza/upper-column', looks.marble, { position: [x + inset, storey, -nave], parent });
  }
  for (let i = 0; i < bays; i++) {
    const x = (i + 0.5) * bayWidth - length / 2;
    build.mesh('Lower arch', 'sponza/lower-arch', looks.stone, { position: [x, 0, -nave], parent });
    build.mesh('Upper arch', 'sponza/upper-arch', looks.stone, { position: [x, storey, -nave], parent });
  }
}

function addFurniture(build: SceneBuilder, looks: Record<string, Look>): void {
  const furniture = build.group('Furniture');
  const cloths = [looks.red, looks.green, looks.blue];
  for (let i = 0; i < 8; i++) {
    const bay = Math.floor(i / 2) * 2 + (i % 2);
    const z = (i % 2 === 0 ? -1 : 1) * (nave + 0.55);
    const position = [(bay + 0.5) * bayWidth - length / 2 - bayWidth / 4, storey + upperSpring + 0.3, z] as const;
    build.mesh('Curtain', 'sponza/curtain', cloths[i % 3], { position, parent: furniture });
  }
  for (let i = 0; i < 4; i++) {
    const x = (i - 1.5) * 9;
    const z = i % 2 === 0 ? -2.9 : 2.9;
    build.mesh('Urn', 'sponza/urn', looks.terracotta, { position: [x, 0, z], parent: furniture });
    build.mesh('Plant', 'sponza/plant', looks.leaf, { position: [x, 0.98, z], parent: furniture });
    const place = { position: [x, storey - 0.48, i % 2 === 0 ? nave + 2.5 : -nave - 2.5], parent: furniture } as const;
    build.mesh('Lamp', 'sponza/lamp', looks.bronze, place);
  }
}
