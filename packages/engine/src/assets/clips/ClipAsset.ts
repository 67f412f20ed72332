import { number, string } from '@farol/editing/fields';
import type { ClipData } from './ClipData';
import { clipText } from './clipText';
import { parseClip } from './parseClip';
import { DataAsset } from '../FieldAsset';

export const clipFields = {
  /** JSON of a `ClipData`; '' for a clip without tracks. */
  data: string('', { help: 'Its tracks and events.', readOnly: true }),
  duration: number(1, { unit: 's', min: 0, step: 0.1, help: 'How long it is.' }),
  frameRate: number(30, { unit: 'Hz', min: 1, max: 240, integer: true, help: 'Frames that the timeline snaps to.' }),
};

/** Animation clip of a library: keyframes for fields of components, and events. */
export class ClipAsset extends DataAsset {
  static readonly fields = clipFields;
  override readonly type = 'clip';

  private parsedText: string | null = null;
  private parsed: ClipData | null = null;

  /** Duration of the animation clip (s). */
  get duration(): number {
    return this.get('duration') as number;
  }

  /** Frames per second to which the timeline snaps keys. */
  get frameRate(): number {
    return this.get('frameRate') as number;
  }

  /**
   * Tracks and events; the same object as long as the text is the same.
   * @throws ClipError when the text is no valid clip
   */
  get clip(): ClipData {
    const text = this.get('data') as string;
    if (!this.parsed || text !== this.parsedText) {
      this.parsed = parseClip(text, this.name);
      this.parsedText = text;
    }
    return this.parsed;
  }

  /** Sets tracks and events, which counts as an edit. Numbers are rounded as `clipText` does. */
  setData(clip: ClipData): void {
    this.set('data', clipText(clip));
  }
}
