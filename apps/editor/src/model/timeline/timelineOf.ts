import type { EditorDocument } from '../EditorDocument';
import { Timeline } from './Timeline';

/** What an editor has that the timeline needs. */
interface TimelineHost {
  timeline: Timeline | null;
  readonly document: EditorDocument;
  readonly viewport: { invalidate(): void };
}

/** The timeline of an editor, made when it is first asked for. */
export const timelineOf = (editor: TimelineHost): Timeline =>
  (editor.timeline ??= new Timeline(editor.document, () => editor.viewport.invalidate()));
