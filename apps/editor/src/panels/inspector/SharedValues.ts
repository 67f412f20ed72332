import { type SharedValue, sharedValue } from '@farol/editing';
import type { FieldOwner } from '@farol/engine/fields';
import type { EditorDocument } from '../../model/EditorDocument';

/** Common values of the fields of several owners, cached: an edit of one field reads only that field again. */
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
    // fields of objects that were temporarily out of the scene may have changed without a signal
    if (structure.revision !== this.structure) known.clear();
    this.structure = structure.revision;
    // recorded values depend on the time; a field that shows another field changes with that field
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
