import { number, string } from '../fields/fields';
import { DataAsset } from './FieldAsset';

/** What a clip is made of. */
export const clipFields = {
  /** JSON of a `ClipData`; '' for a clip without tracks. */
  data: string('', { help: 'Its tracks and events.', readOnly: true }),
  duration: number(1, { unit: 's', min: 0, step: 0.1, help: 'How long it is.' }),
  frameRate: number(30, { unit: 'Hz', min: 1, max: 240, integer: true, help: 'Frames that the timeline snaps to.' }),
};

/** A clip of a library: how values of fields go with time. */
export class ClipAsset extends DataAsset {
  static readonly fields = clipFields;
  override readonly type = 'clip';
}
