import type { ClipData } from '@farol/engine';
import { keptSelection, type KeySelection } from './editKeys';

/** Number of clip states whose selections are remembered, so that undo restores the selection. */
const REMEMBERED = 200;

/** Selected keys, or indices of selected events. */
export interface ClipSelection {
  readonly keys: KeySelection;
  readonly events: readonly number[];
}

const NOTHING: ClipSelection = { keys: new Set(), events: [] };

/** The selection in the edited clip, remembered for each of its states (as serialised text). */
export class ClipSelections {
  /** Serialised data of the clip that `current` belongs to; '' for none. */
  text = '';
  current: ClipSelection = NOTHING;
  private readonly byText = new Map<string, ClipSelection>();

  /** Switches to another clip, restoring the selection remembered for its text. */
  show(text: string): void {
    this.text = text;
    this.current = this.byText.get(text) ?? NOTHING;
  }

  select(selection: ClipSelection): void {
    this.current = selection;
    this.remember();
  }

  /** Remembers a selection for a clip's future text, before the edit that leads to it. */
  expect(text: string, selection: ClipSelection): void {
    this.remember();
    this.byText.set(text, selection);
    if (text === this.text) this.current = selection;
  }

  /** Called after edits, undo included: restores the selection that was made with the clip's current text. */
  follow(text: string, data: ClipData): void {
    if (text === this.text) return;
    this.text = text;
    this.current = this.byText.get(text) ?? { keys: keptSelection(data, this.current.keys), events: [] };
  }

  forget(): void {
    this.byText.clear();
  }

  private remember(): void {
    this.byText.delete(this.text);
    this.byText.set(this.text, this.current);
    if (this.byText.size > REMEMBERED) this.byText.delete(this.byText.keys().next().value!);
  }
}
