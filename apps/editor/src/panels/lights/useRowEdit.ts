import type { FieldGesture, FieldUpdate } from '@farol/editing';
import { useRef } from 'react';
import type { EditorApi } from '../../api/EditorApi';

/** Callbacks of a cell that edits a field. */
export interface RowEdit {
  onPreview(update: FieldUpdate): void;
  onCommit(): void;
  onDiscard(): void;
}

/** Edits by a gesture that is made when an edit begins, for the rows that are selected then. */
export function useRowEdit(editor: EditorApi, make: () => FieldGesture): RowEdit {
  const gesture = useRef<FieldGesture | null>(null);
  const end = (): FieldGesture | null => {
    const { current } = gesture;
    gesture.current = null;
    return current;
  };
  return {
    onPreview: (update) => editor.attempt(() => (gesture.current ??= make()).preview(update)),
    onCommit: () => editor.attempt(() => end()?.commit()),
    onDiscard: () => end()?.discard(),
  };
}
