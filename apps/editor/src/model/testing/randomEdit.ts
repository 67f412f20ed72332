import { SetFields } from '@farol/editing';
import type { FieldOwner } from '@farol/engine/fields';
import type { EditorDocument } from '../EditorDocument';
import { pick, type Random } from './random';
import { randomValue } from './randomValue';

export function randomEdit(random: Random, document: EditorDocument, owner: FieldOwner): SetFields {
  const name = pick(random, Object.keys(owner.fields));
  return new SetFields(`Set ${name}`, [{ owner, name, value: randomValue(random, owner.fields[name], document) }]);
}
