import { t } from '@farol/editing';
import { Dialog } from '@base-ui/react/dialog';
import { type ReactNode, useState } from 'react';
import type { TextDialog as TextRequest } from '../../model/Dialogs';
import { useEditor } from '../../ui/EditorContext';
import { Button } from '../../ui/Button';

/** Asks for a line of text. Enter accepts, Escape cancels. */
export function TextDialog({ request, onClose }: { request: TextRequest; onClose(): void }): ReactNode {
  const editor = useEditor();
  const [value, setValue] = useState(request.value);
  const text = value.trim();
  return (
    <form
      className="text-dialog"
      onSubmit={(event) => {
        event.preventDefault();
        if (text === '') return;
        onClose();
        editor.attempt(() => request.accept(text));
      }}
    >
      <Dialog.Title>{request.title}</Dialog.Title>
      <label>
        {request.label}
        <input
          className="input"
          type="text"
          value={value}
          autoComplete="off"
          spellCheck={false}
          onFocus={(event) => event.currentTarget.select()}
          onChange={(event) => setValue(event.target.value)}
        />
      </label>
      <div className="dialog-buttons">
        <Button label={t('Cancel')} onClick={onClose} />
        <Button look="primary" label={request.action} type="submit" disabled={text === ''} />
      </div>
    </form>
  );
}
