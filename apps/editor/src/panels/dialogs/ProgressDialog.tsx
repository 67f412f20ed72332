import { t } from '@farol/editing';
import { Dialog } from '@base-ui/react/dialog';
import type { ReactNode } from 'react';
import type { ProgressDialog as ProgressRequest, WorkProgress } from '../../model/Dialogs';
import { Button } from '../../ui/Button';
import { useSignal } from '../../ui/EditorContext';

/** Shows the progress of a long task, with a button to cancel it. */
export function ProgressDialog({ request, onClose }: { request: ProgressRequest; onClose(): void }): ReactNode {
  return (
    <>
      <Dialog.Title>{request.title}</Dialog.Title>
      {request.progress ? (
        <KnownProgress title={request.title} progress={request.progress} />
      ) : (
        <progress className="progress" aria-label={request.title} />
      )}
      <div className="dialog-buttons">
        <Button label={t('Cancel')} onClick={onClose} />
      </div>
    </>
  );
}

function KnownProgress({ title, progress }: { title: string; progress: WorkProgress }): ReactNode {
  useSignal(progress.changed);
  return (
    <>
      <progress className="progress" aria-label={title} value={progress.share} />
      <Dialog.Description>{progress.text}</Dialog.Description>
    </>
  );
}
