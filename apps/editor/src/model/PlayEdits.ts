import { type Command, type CommandStack, labelOfField, SetFields, Signal, t } from '@farol/editing';
import {
  type Component,
  type FieldAsset,
  type Scene,
  ScriptAsset,
  type SceneSettings,
  SurfaceAsset,
  type TakenAsset,
} from '@farol/engine';
import { checkFieldValue, type FieldOwner, type FieldValue, sameValue } from '@farol/engine/fields';
import { AddAssets, RemoveAsset } from './commands/AddAssets';
import { CommandList } from './commands/CommandList';
import { Sequence } from './commands/Sequence';

/** A value that was edited while the scene played. */
export interface PlayChange {
  readonly owner: Component | SceneSettings | FieldAsset;
  /** Name of the field. */
  readonly name: string;
  /** What it is, as before playing. */
  readonly from: FieldValue;
  /** What it was when the scene was stopped. */
  readonly to: FieldValue;
}

const sameField = (a: { owner: FieldOwner; name: string }, b: { owner: FieldOwner; name: string }): boolean =>
  a.owner === b.owner && a.name === b.name;

/**
 * What becomes of edits that are made while the scene plays: stopping takes all of them back, and whatever components
 * wrote into fields too. Those of values can then be kept, one by one.
 */
export class PlayEdits {
  /** Emits when there is something to keep, or no longer. */
  readonly changed = new Signal();

  private values: readonly PlayChange[] = [];
  /** All edits as they were done, while none of them was kept. */
  private all: readonly Command[] = [];
  private last: Command | null = null;
  /** Names of the assets that there were when the scene began to play. */
  private assetsBefore: ReadonlySet<string> = new Set();

  constructor(private readonly document: { readonly commands: CommandStack; readonly scene: Scene }) {}

  /**
   * Values that can be kept: of fields that are there, since a script's text may have changed after the scene stopped, and no
   * names of assets that are gone, since those that were made or renamed while it played are.
   */
  get changes(): readonly PlayChange[] {
    const { assets } = this.document.scene;
    return this.values.filter(({ owner, name, to }) => {
      const field = Object.hasOwn(owner.fields, name) ? owner.fields[name] : null;
      if (field?.kind !== 'asset' || typeof to !== 'string') return field !== null;
      return assets.problemWith(field.assetType, to) === null;
    });
  }

  /** Labels of edits that are no values, such as an object that was added; they can be kept only with all others. */
  get others(): readonly string[] {
    return this.all.filter((command) => !(command instanceof SetFields)).map(({ label }) => label);
  }

  /** Whether everything can be kept as it was done: while nothing else was edited. */
  get canKeepAll(): boolean {
    return this.all.length > 0 && this.document.commands.last === this.last;
  }

  /** The scene begins to play. */
  begin(): void {
    this.dismiss();
    const { scene } = this.document;
    scene.keepAuthored();
    this.assetsBefore = new Set(scene.assets.list());
    this.document.commands.hold();
  }

  /**
   * The scene stops: it is as it was when it began to play, but for scripts: what was typed of them meanwhile stays, as steps.
   * @param reset - puts simulation back to time 0, and takes back what components changed
   */
  end(reset: () => void): void {
    const { commands } = this.document;
    let isWhole = true;
    // of what a component has removed a step cannot be undone; the scene takes back what is left of it
    const taken = commands.release(() => (isWhole = false));
    reset();
    this.takeAssets();
    const others = taken.filter((command) => !isOfScripts(command));
    for (const command of taken) if (isOfScripts(command)) commands.run(command);
    this.all = isWhole ? others.map(asNew) : [];
    if (!isWhole) for (const command of others) command.forget?.(false);
    this.last = commands.last;
    this.values = changesOf(others);
    this.changed.emit();
  }

  /** Another scene came. */
  abort(): void {
    this.dismiss();
  }

  /** Keeps a value, as one step of history. @throws Error when its object is not in the scene: it was added while playing */
  keep(change: PlayChange): void {
    const { owner, name, to } = change;
    this.check(change);
    this.document.commands.run(new SetFields(t('Kept {name}', { name: nameOf(change) }), [{ owner, name, value: to }]));
    this.values = this.values.filter((each) => !sameField(each, change));
    this.dropAll();
    this.changed.emit();
  }

  /** Keeps what is left, as one step of history. @throws Error as `keep` does; nothing is kept then */
  keepAll(): void {
    if (this.canKeepAll) {
      this.document.commands.run(new CommandList(t('Kept the edits made while playing'), this.all));
      this.all = [];
    } else {
      for (const change of this.changes) this.check(change);
      const edits = this.changes.map(({ owner, name, to }) => ({ owner, name, value: to }));
      this.document.commands.run(new SetFields(t('Kept the edits made while playing'), edits));
    }
    this.dismiss();
  }

  /** Lets go of what was not kept. */
  dismiss(): void {
    this.dropAll();
    this.values = [];
    this.changed.emit();
  }

  /** Takes out the assets that components and scripts have registered while the scene played; all steps are taken back. */
  private takeAssets(): void {
    const { assets } = this.document.scene;
    for (const name of assets.list()) {
      // parts of a model go with it; of one that was loaded meanwhile they are new, and stay
      if (this.assetsBefore.has(name) || assets.modelOf(name) !== null) continue;
      for (const each of withParts(assets.take(name))) each.value?.dispose();
    }
  }

  private check(change: PlayChange): void {
    if ('isAttached' in change.owner && change.owner.scene !== this.document.scene) {
      throw new Error(
        t('{name} cannot be kept: its object was added while playing. Keep all edits instead.', {
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

/** Whether a step makes, deletes or edits scripts, or texts of surfaces, alone. */
function isOfScripts(command: Command): boolean {
  if (command instanceof Sequence) return command.parts.length > 0 && command.parts.every(isOfScripts);
  return command instanceof SetFields
    ? command.edits.every(({ owner }) => owner instanceof ScriptAsset || owner instanceof SurfaceAsset)
    : (command instanceof AddAssets || command instanceof RemoveAsset) && command.isOfScripts;
}

/** An edit of values that has not been done: texts of scripts that stay may give the fields other values to go back to. */
const asNew = (command: Command): Command =>
  command instanceof SetFields ? new SetFields(command.label, command.edits) : command;

/** What a change is of, such as 'intensity of Lamp'. */
export function nameOf({ owner, name }: PlayChange): string {
  const field = labelOfField(name, owner.fields[name]).toLowerCase();
  return t('{field} of {name}', {
    field,
    name: 'isAttached' in owner && owner.isAttached ? owner.gameObject.name : owner.ownerName,
  });
}

/** The values that commands, which are undone, have set, of fields that are there without them. */
function changesOf(commands: readonly Command[]): PlayChange[] {
  const changes: PlayChange[] = [];
  for (const command of commands) {
    if (!(command instanceof SetFields)) continue;
    for (const { owner, name, value } of command.edits) {
      const at = changes.findIndex((each) => sameField(each, { owner, name }));
      if (at >= 0) changes.splice(at, 1);
      // a uniform of a surface that was worn, or typed, while it played
      if (!Object.hasOwn(owner.fields, name) || checkFieldValue(owner.fields[name], value) !== null) continue;
      const change = { owner: owner as PlayChange['owner'], name, from: owner.getAuthored(name), to: value };
      if (!sameValue(change.from, value)) changes.push(change);
    }
  }
  return changes;
}
