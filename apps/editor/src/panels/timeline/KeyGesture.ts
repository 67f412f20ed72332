import { type Command, type CommandStack, t } from '@farol/editing';
import type { FieldValue } from '@farol/engine/fields';
import { clipName, setClip } from '../../model/timeline/clipEdits';
import { type KeyEdit, type KeySelection, retimeKeys, setValuesOfKeys } from '../../model/timeline/editKeys';
import type { ClipGesture, Timeline } from '../../model/timeline/Timeline';
import { movedLabel } from '../../model/timeline/timelineEdits';

type Update = FieldValue | ((before: FieldValue) => FieldValue);

const valueOf =
  (update: Update) =>
  (before: FieldValue): FieldValue =>
    typeof update === 'function' ? update(before) : update;

/** Edits times or values of the selected keys from fields: previewed meanwhile, then one step of history. */
export class KeyGesture {
  private gesture: ClipGesture | null = null;
  private selected: KeySelection = new Set();
  private step: Command | null = null;

  constructor(
    private readonly timeline: Timeline,
    private readonly commands: CommandStack,
  ) {}

  previewValues(update: Update): void {
    this.preview(this.label, ({ data }) => setValuesOfKeys(data, this.selected, valueOf(update)));
  }

  previewTimes(timeOf: (time: number) => number): void {
    this.preview(movedLabel(this.timeline, this.timeline.selection.keys.size), ({ data }) =>
      retimeKeys(data, this.selected, (time) => Math.max(timeOf(time), 0)),
    );
  }

  /** Commits the last preview, or this value, as one step of history. */
  commit(update?: Update): void {
    if (update !== undefined) this.previewValues(update);
    const { last } = this.commands;
    this.gesture?.commit();
    this.gesture = null;
    this.step = this.commands.last === last ? null : this.commands.last;
  }

  /** Merges a value that arrives after the commit into the same step of history. */
  amend(update: Update): void {
    const { clip, data, selection } = this.timeline;
    if (!this.step || !clip) this.commit(update);
    else if (
      this.commands.amend(this.step, setClip(this.label, clip, setValuesOfKeys(data, selection.keys, valueOf(update))))
    )
      this.step = this.commands.last;
  }

  discard(): void {
    this.gesture?.discard();
    this.gesture = null;
  }

  private get label(): string {
    const { clip } = this.timeline;
    return t('Set values of keys of {name}', { name: clip ? clipName(clip) : '' });
  }

  private preview(label: string, edit: (gesture: ClipGesture) => KeyEdit | ReturnType<typeof setValuesOfKeys>): void {
    if (!this.gesture) {
      this.selected = this.timeline.selection.keys;
      this.gesture = this.timeline.beginEdit();
    }
    if (this.gesture) this.gesture.preview(label, edit(this.gesture));
  }
}
