import { Dialog } from '@base-ui/react/dialog';
import { type ReactNode, useState } from 'react';
import { recover } from '../../files/autosave/startAutosave';
import type { RecoverDialog as RecoverRequest } from '../../model/Dialogs';
import { useEditor } from '../../ui/EditorContext';

const when = new Intl.DateTimeFormat(undefined, { dateStyle: 'medium', timeStyle: 'short' });

/** What tabs that were closed without warning have left; each can be brought back, or thrown away. */
export function RecoverDialog({ request, onClose }: { request: RecoverRequest; onClose(): void }): ReactNode {
  const editor = useEditor();
  const { autosave } = request;
  const [sessions, setSessions] = useState(request.sessions);
  return (
    <>
      <Dialog.Title>Unsaved work was found</Dialog.Title>
      <Dialog.Description>The editor was closed before these scenes were saved.</Dialog.Description>
      <ul className="sessions">
        {sessions.map((session) => (
          <li key={session.id}>
            <span className="session-name">
              {session.name}
              <span className="session-time">
                {when.format(session.time)}
                {session.fileName && `, ${session.fileName}`}
              </span>
            </span>
            <button
              type="button"
              className="button framed"
              onClick={() =>
                editor.attempt(async () => {
                  await autosave.store.delete(session.id);
                  const left = sessions.filter((each) => each !== session);
                  setSessions(left);
                  if (left.length === 0) onClose();
                })
              }
            >
              Discard
            </button>
            <button
              type="button"
              className="button primary"
              onClick={() => {
                onClose();
                editor.attempt(() => recover(editor, autosave, session));
              }}
            >
              Recover
            </button>
          </li>
        ))}
      </ul>
      <div className="dialog-buttons">
        <span className="dialog-hint">What is left for later stays: “Recover…” in the menu File offers it again.</span>
        <button type="button" className="button framed" onClick={onClose}>
          Later
        </button>
      </div>
    </>
  );
}
