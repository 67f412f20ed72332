import type { Command } from '@farol/editing';
import type { Scene } from '@farol/engine';
import { type BakeData, BakedLight, bakeSignature, bakeSources } from '@farol/engine/bake';
import { bakeLights, clearBakedLight, lightsInPlace, objectsInPlace, showBakedLight } from '../bakeEdits';
import { setStatic } from '../edits';
import type { EditorDocument } from '../EditorDocument';
import { below, type Random } from './random';

/** Baked light for the current scene, made without casting rays. */
function bakeOf(scene: Scene): BakeData {
  const { meshes, lights } = bakeSources(scene);
  return {
    signature: bakeSignature(scene),
    lights: lights.filter(({ mode }) => mode === 'baked').map(({ id }) => id),
    hasSky: false,
    channel: 1,
    lightmaps: [{ width: 1, height: 1, data: new Uint16Array(4) }],
    meshes: meshes.map(({ mesh, component, part }) => {
      const count = mesh.geometry.getAttribute('position').count;
      const vertices = Uint32Array.from({ length: count }, (_, i) => i);
      const index = Uint32Array.from(mesh.geometry.index?.array ?? vertices);
      const uv1 = new Float32Array(2 * count);
      return { component: component.id, part, lightmap: 0, sourceVertices: count, sourceVertex: vertices, index, uv1 };
    }),
    probes: null,
  };
}

/** Bakes again, clears the baked light, or makes more of the scene static. */
export function randomBakeCommand(random: Random, { scene, assets }: EditorDocument): Command {
  switch (below(random, 4)) {
    case 0:
      return setStatic(objectsInPlace(scene), true);
    case 1:
      return bakeLights(lightsInPlace(scene));
    case 2:
      return clearBakedLight(scene);
    default: {
      let name = '';
      do name = `Light ${below(random, 1000)}`;
      while (assets.has(name));
      assets.register(name, new BakedLight(bakeOf(scene)));
      return showBakedLight(scene, assets.take(name));
    }
  }
}

/** Description of which lights shine and which meshes have lightmaps. */
export function litBy(scene: Scene): string {
  const words: string[] = [];
  scene.three.traverse((object) => {
    if ('isLight' in object) words.push(`${object.parent?.name} ${object.visible}`);
    const { material } = object as { material?: { lightMap?: unknown } };
    if (material?.lightMap) words.push(`${object.parent?.name} lightmap`);
  });
  return words.toSorted().join();
}
