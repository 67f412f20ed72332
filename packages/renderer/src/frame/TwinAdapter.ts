import type { TwinKind } from '../materials/TwinKind';
import type { RenderItem } from './RenderItem';

/** Replaces the kind of twin that an item is drawn with, or returns it unchanged. */
export interface TwinAdapter {
  adapt(kind: TwinKind, item: RenderItem): TwinKind;
}
