import type { EditorDocument } from '../EditorDocument';
import { Timeline } from './Timeline';

/** The part of an editor that the timeline uses. */
interface TimelineHost {
  timeline: Timeline | null;
  readonly document: EditorDocument;
  readonly viewport: { invalidate(): void };
}

/** The timeline of an editor, created at the first call. */
export const timelineOf = (editor: TimelineHost): Timeline =>
  (editor.timeline ??= new Timeline(editor.document, () => editor.viewport.invalidate()));
