import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { Button } from '../../ui/Button';
import { useEditor } from '../../ui/EditorContext';

interface CopyProps {
  readonly text: string;
  readonly label: string;
  readonly disabled?: boolean;
}

/** Button that copies a text, and confirms it in its label. */
export function CopyButton({ text, label, disabled }: CopyProps): ReactNode {
  const editor = useEditor();
  const copy = async (): Promise<void> => {
    await navigator.clipboard.writeText(text);
    editor.notices.show('info', t('{label} copied', { label }));
  };
  return <Button label={t('Copy')} disabled={disabled} onClick={() => editor.attempt(copy)} />;
}
