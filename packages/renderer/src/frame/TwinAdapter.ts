import type { TwinKind } from '../materials/TwinKind';
import type { RenderItem } from './RenderItem';

/** Gives the kind of twin that an item is drawn with in place of another, or that one. */
export interface TwinAdapter {
  adapt(kind: TwinKind, item: RenderItem): TwinKind;
}
