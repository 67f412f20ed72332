import { type Command, SetFields } from '@farol/editing';
import { type FieldAsset, GameObject } from '@farol/engine';
import { AddAssets, RemoveAsset } from '../commands/AddAssets';
import { addComponent } from '../edits';
import type { EditorDocument } from '../EditorDocument';
import { below, objectsOf, pick, type Random } from './random';

/** Field tables that a script may declare: a field's kind and default differ among them, and some lack it. */
const tables = [
  'rate: number(1, { help })',
  'rate: number(2, { help }), word: string("a", { help })',
  'rate: string("slow", { help }), far: boolean(true, { help })',
  'word: string("b", { help }), at: vector3([1, 2, 3], { help })',
];

const textOf = (
  table: string,
  count: number,
): string => `import { boolean, component, number, string, vector3 } from '@farol/engine/fields';
const help = 'For a test.';
export default class Spin extends component({ ${table} }) {
  static version = 1;
  turned = ${count};
  update() {
    this.turned++;
    this.gameObject.object3D.rotateY(1);
  }
}`;

/**
 * Makes, edits, breaks, deletes or uses scripts. Null while the scene plays, since edits of scripts survive stopping.
 */
export function randomRunningScript(random: Random, document: EditorDocument): Command | null {
  const { scene, assets, simulation } = document;
  if (simulation.state !== 'stopped') return null;
  const scripts = assets.fieldAssets('script');
  const source = random() < 0.15 ? 'export default class {' : textOf(pick(random, tables), below(random, 3));
  const act = below(random, 6);
  if (act === 0 && scripts.length < 2) {
    const name = `Script ${below(random, 3)}`;
    if (assets.has(name)) return null;
    assets.addFieldAsset('script', name, { source });
    return new AddAssets(assets, [assets.take(name)]);
  }
  const script: FieldAsset | undefined = pick(random, scripts);
  if (!script) return null;
  if (act === 1) return new RemoveAsset(assets, script.name);
  if (act < 4) return new SetFields('Edited script', [{ owner: script, name: 'source', value: source }]);
  const type = document.scripts.classOf(script.name);
  const object = pick(random, objectsOf(scene));
  return type && object instanceof GameObject ? addComponent(scene, [object], type) : null;
}
