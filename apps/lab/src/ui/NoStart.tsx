/** The page where nothing can be measured. */
export function NoStart({ problem }: { problem: string }) {
  return (
    <main class="no-start">
      <h1>Farol Lab cannot measure here</h1>
      <p role="alert">{problem}</p>
    </main>
  );
}
