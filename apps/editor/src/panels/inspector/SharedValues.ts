import { type SharedValue, sharedValue } from '@farol/editing';
import type { FieldOwner } from '@farol/engine/fields';
import type { EditorDocument } from '../../model/EditorDocument';

/** Common values of the fields of several owners: an edit of one field reads that one again, not all of each owner. */
export class SharedValues {
  private readonly known = new Map<string, SharedValue>();
  private structure = 0;

  constructor(
    private readonly owners: readonly FieldOwner[],
    private readonly document: EditorDocument,
  ) {}

  of(name: string): SharedValue {
    const { owners, known } = this;
    const { commands, structure } = this.document;
    // fields of objects that were out of the scene for a moment change untold
    if (structure.revision !== this.structure) known.clear();
    this.structure = structure.revision;
    // a recorded clip has other values at other times; a view changes with the field that it is a part of
    if (commands.recorder || owners[0].fields[name].viewOf) known.delete(name);
    const value = known.get(name) ?? sharedValue(owners.map((owner) => commands.valueOf(owner, name)));
    if (!commands.recorder) known.set(name, value);
    return value;
  }

  /** Called when a field of an owner has changed. @param name - all fields when absent */
  readonly forget = (name?: string): void => {
    if (name === undefined) this.known.clear();
    else this.known.delete(name);
  };
}
