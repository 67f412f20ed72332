import type { AssetField } from '@farol/engine';
import { type ReactNode, useMemo } from 'react';
import { useEditor } from '../ui/EditorContext';
import { SearchSelect } from '../ui/SearchSelect';
import type { FieldEditorProps } from './FieldEditorProps';

export function AssetEditor(props: FieldEditorProps<AssetField>): ReactNode {
  const { field, value, mixed, label, description, disabled, onCommit } = props;
  const { assets } = useEditor().document;
  const { assetType } = field;
  const names = assets.list(assetType).join('\n');
  const options = useMemo(
    () =>
      names
        .split('\n')
        .filter(Boolean)
        .map((name) => ({ value: name, label: name })),
    [names],
  );
  const placeholder = mixed ? '—' : `No ${assetType}`;
  return <SearchSelect {...{ value, options, label, description, disabled, placeholder }} onChange={onCommit} />;
}
