import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { useEditor } from '../../ui/EditorContext';
import { Button } from '../../ui/Button';

/** Button that opens the text of a surface. */
export function EditSurface({ name }: { name: string }): ReactNode {
  const editor = useEditor();
  return <Button icon="code" label={t('Edit its text')} onClick={() => editor.openMicroShader(`surface:${name}`)} />;
}
