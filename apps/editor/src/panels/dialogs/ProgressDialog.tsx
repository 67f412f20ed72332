import { t } from '@farol/editing';
import { Dialog } from '@base-ui/react/dialog';
import type { ReactNode } from 'react';
import type { ProgressDialog as ProgressRequest } from '../../model/Dialogs';
import { Button } from '../../ui/Button';

/** Shows the progress of a long task, with a button to cancel it. */
export function ProgressDialog({ request, onClose }: { request: ProgressRequest; onClose(): void }): ReactNode {
  return (
    <>
      <Dialog.Title>{request.title}</Dialog.Title>
      <progress className="progress" aria-label={request.title} />
      <div className="dialog-buttons">
        <Button label={t('Cancel')} onClick={onClose} />
      </div>
    </>
  );
}
