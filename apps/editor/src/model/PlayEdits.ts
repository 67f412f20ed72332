import { type Command, currentOf, labelOfField, SetFields, Signal, t } from '@farol/editing';
import {
  type Component,
  type FieldAsset,
  ScriptAsset,
  type SceneSettings,
  SurfaceAsset,
  type TakenAsset,
} from '@farol/engine';
import { checkFieldValue, type FieldOwner, type FieldValue, sameValue } from '@farol/engine/fields';
import { AddAssets, RemoveAsset } from './commands/AddAssets';
import { Sequence } from './commands/Sequence';
import type { EditorDocument } from './EditorDocument';

/** A field value edited while the scene played. */
export interface PlayChange {
  readonly owner: Component | SceneSettings | FieldAsset;
  readonly name: string;
  /** Value before the scene began to play. */
  readonly from: FieldValue;
  /** Value when the scene was stopped. */
  readonly to: FieldValue;
}

const sameField = (a: { owner: FieldOwner; name: string }, b: { owner: FieldOwner; name: string }): boolean =>
  currentOf(a.owner) === currentOf(b.owner) && a.name === b.name;

/**
 * Edits made while the scene plays. Stopping undoes all of them, and what components wrote into fields; edited values
 * can then be kept one by one, or all edits together.
 */
export class PlayEdits {
  /** Emits when `changes` or `others` become empty or not empty. */
  readonly changed = new Signal();

  private values: readonly PlayChange[] = [];
  /** All edits in the order they were made; empty once one of them was kept on its own. */
  private all: readonly Command[] = [];
  private last: Command | null = null;
  /** Names of the assets when the scene began to play. */
  private assetsBefore: ReadonlySet<string> = new Set();

  constructor(private readonly document: Pick<EditorDocument, 'commands' | 'scene' | 'scripts'>) {}

  /**
   * Values that can be kept. Without fields that no longer exist (a script's text may have changed since), and without
   * names of assets that no longer exist (made or renamed while the scene played).
   */
  get changes(): readonly PlayChange[] {
    const { assets } = this.document.scene;
    return this.values.filter(({ owner: edited, name, to }) => {
      const owner = currentOf(edited);
      const field = Object.hasOwn(owner.fields, name) ? owner.fields[name] : null;
      if (field?.kind !== 'asset' || typeof to !== 'string') return field !== null;
      return assets.problemWith(field.assetType, to) === null;
    });
  }

  /** Labels of edits other than of field values, such as an added object; these can only be kept together with all edits. */
  get others(): readonly string[] {
    return this.all.filter((command) => !(command instanceof SetFields)).map(({ label }) => label);
  }

  /** Whether all edits can be kept as they were made: nothing was edited since the scene stopped. */
  get canKeepAll(): boolean {
    return this.all.length > 0 && this.document.commands.last === this.last;
  }

  /** Called when the scene begins to play: notes its authored values and assets, and starts collecting edits. */
  begin(): void {
    this.dismiss();
    const { scene, scripts } = this.document;
    scripts.forgetFailures();
    scene.keepAuthored();
    this.assetsBefore = new Set(scene.assets.list());
    this.document.commands.hold();
  }

  /**
   * Called when the scene stops: every edit is undone, except those of scripts, which stay as steps of the history.
   * @param reset - sets the simulation to time 0, and undoes what components changed
   */
  end(reset: () => void): void {
    const { commands } = this.document;
    let isWhole = true;
    // an edit of an object that a component removed cannot be undone; the scene restores what is left of the object
    const taken = commands.release(() => (isWhole = false));
    reset();
    this.takeAssets();
    const others = taken.filter((command) => !isOfScripts(command) || !this.runAgain(command));
    this.all = isWhole ? others.map(asNew) : [];
    if (!isWhole) for (const command of others) command.forget?.(false);
    this.last = commands.last;
    this.values = changesOf(others);
    this.changed.emit();
  }

  /** Keeps a value, as one step of history. @throws Error when its object was removed by Stop */
  keep(change: PlayChange): void {
    const { owner, name, to } = change;
    this.check(change);
    this.document.commands.run(new SetFields(t('Kept {name}', { name: nameOf(change) }), [{ owner, name, value: to }]));
    this.values = this.values.filter((each) => !sameField(each, change));
    this.dropAll();
    this.changed.emit();
  }

  /** Keeps all remaining values, as one step of history. @throws Error as `keep` does; then nothing is kept */
  keepAll(): void {
    if (this.canKeepAll) {
      this.document.commands.run(Sequence.of(t('Kept the edits made while playing'), this.all));
      this.all = [];
    } else {
      for (const change of this.changes) this.check(change);
      const edits = this.changes.map(({ owner, name, to }) => ({ owner, name, value: to }));
      this.document.commands.run(new SetFields(t('Kept the edits made while playing'), edits));
    }
    this.dismiss();
  }

  /** Forgets the changes made while playing that the user has not kept, also when another scene was opened. */
  dismiss(): void {
    this.dropAll();
    this.values = [];
    this.changed.emit();
  }

  /** Runs an undone step again. @returns false when it needs another step that stays undone, such as a new name */
  private runAgain(command: Command): boolean {
    try {
      this.document.commands.run(command);
      return true;
    } catch {
      return false;
    }
  }

  /** Removes the assets that components and scripts registered while the scene played; edits must be undone already. */
  private takeAssets(): void {
    const { assets } = this.document.scene;
    for (const name of assets.list()) {
      // parts are removed with their model; parts of a model that finished loading meanwhile are new, and stay
      if (this.assetsBefore.has(name) || assets.modelOf(name) !== null) continue;
      for (const each of withParts(assets.take(name))) each.value?.dispose();
    }
  }

  private check(change: PlayChange): void {
    const owner = currentOf(change.owner);
    if ('isAttached' in owner && owner.scene !== this.document.scene) {
      throw new Error(
        t('{name} cannot be kept alone: its object was added while playing. Keep all edits.', {
          name: nameOf(change),
        }),
      );
    }
  }

  private dropAll(): void {
    for (const command of this.all) command.forget?.(false);
    this.all = [];
  }
}

const withParts = (taken: TakenAsset): TakenAsset[] => [taken, ...taken.parts.flatMap(withParts)];

/** Whether a command makes, deletes or edits only scripts or texts of surfaces. */
function isOfScripts(command: Command): boolean {
  if (command instanceof Sequence) return command.parts.length > 0 && command.parts.every(isOfScripts);
  return command instanceof SetFields
    ? command.edits.every(({ owner }) => owner instanceof ScriptAsset || owner instanceof SurfaceAsset)
    : (command instanceof AddAssets || command instanceof RemoveAsset) && command.isOfScripts;
}

/** A copy of a SetFields as if never done: scripts may have changed the values that its undo would restore. */
const asNew = (command: Command): Command =>
  command instanceof SetFields ? new SetFields(command.label, command.edits) : command;

/** Name of a changed value, such as 'intensity of Lamp'. */
export function nameOf({ owner: edited, name }: PlayChange): string {
  const owner = currentOf(edited);
  const field = labelOfField(name, owner.fields[name]).toLowerCase();
  return t('{field} of {name}', {
    field,
    name: 'isAttached' in owner && owner.isAttached ? owner.gameObject.name : owner.ownerName,
  });
}

/** The values that undone commands had set, of fields that still exist. */
function changesOf(commands: readonly Command[]): PlayChange[] {
  const changes: PlayChange[] = [];
  for (const command of commands) {
    if (!(command instanceof SetFields)) continue;
    for (const { owner: edited, name, value } of command.edits) {
      const owner = currentOf(edited);
      const at = changes.findIndex((each) => sameField(each, { owner, name }));
      if (at >= 0) changes.splice(at, 1);
      // skipped: the field was a uniform of a surface that was assigned or typed while the scene played, and is gone
      if (!Object.hasOwn(owner.fields, name) || checkFieldValue(owner.fields[name], value) !== null) continue;
      const change = { owner: owner as PlayChange['owner'], name, from: owner.getAuthored(name), to: value };
      if (!sameValue(change.from, value)) changes.push(change);
    }
  }
  return changes;
}
