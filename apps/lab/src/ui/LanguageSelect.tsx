import { type Language, languages, t, textLanguage } from '@farol/editing';
import { messageOf } from '../run/messageOf';

interface LanguageSelectProps {
  /** Switches the page's language. @throws Error (as a rejection) when its texts cannot be fetched */
  onLanguage(language: Language): Promise<void>;
  onProblem(problem: string): void;
}

/** Select for the page's language. */
export function LanguageSelect({ onLanguage, onProblem }: LanguageSelectProps) {
  const choose = (language: Language): void => {
    onLanguage(language).catch((error: unknown) => onProblem(messageOf(error)));
  };
  return (
    <label class="inline-field">
      {t('Language')}
      <select value={textLanguage()} onChange={({ currentTarget }) => choose(currentTarget.value as Language)}>
        {Object.entries(languages).map(([value, label]) => (
          <option key={value} value={value} lang={value}>
            {label}
          </option>
        ))}
      </select>
    </label>
  );
}
