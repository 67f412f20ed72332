import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import type { MicroShaderProblemText } from '../../microshaders/TextDrafts';
import { useEditor } from '../../ui/EditorContext';

interface ChunkErrorsProps {
  /** Name of the microshader in the console's entries. */
  readonly name: string;
  /** Name of the microshader whose text the panel shows. */
  readonly shown: string;
  readonly problem: MicroShaderProblemText;
}

/** Compiler messages by microshader and line; a click opens the place. */
export function ChunkErrors({ name, shown, problem }: ChunkErrorsProps): ReactNode {
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
            onClick={() => editor.openMicroShader(chunk === null || chunk === name ? shown : chunk, line)}
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
