import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import type { MicroShaderProblemText } from '../../microshaders/MicroShaderEditing';
import { useEditor } from '../../ui/EditorContext';

/** What the compiler says, by chunk and line; a click goes there. */
export function ChunkErrors({ name, problem }: { name: string; problem: MicroShaderProblemText }): ReactNode {
  const editor = useEditor();
  const { entries, message } = problem;
  return (
    <ul className="chunk-errors" aria-label={t('Errors')}>
      {entries.length === 0 && <li>{message}</li>}
      {entries.map(({ chunk, line, message: text, text: code }) => (
        <li key={`${chunk}:${line}:${text}`}>
          <button
            type="button"
            disabled={chunk === null || chunk.startsWith('three/')}
            onClick={() => editor.openMicroShader(chunk ?? name, line)}
          >
            {chunk ?? t('shader')}:{line}
          </button>
          <span>{text}</span>
          {chunk !== name && <code>{code}</code>}
        </li>
      ))}
    </ul>
  );
}
