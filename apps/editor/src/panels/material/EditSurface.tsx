import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { useEditor } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';

/** Button that opens the text of a surface. */
export function EditSurface({ name }: { name: string }): ReactNode {
  const editor = useEditor();
  return (
    <button type="button" className="button framed" onClick={() => editor.openMicroShader(`surface:${name}`)}>
      <Icon name="code" />
      <span>{t('Edit its text')}</span>
    </button>
  );
}
