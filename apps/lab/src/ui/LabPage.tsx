/** The whole page. */
export function LabPage() {
  return (
    <main>
      <h1>Farol Lab</h1>
    </main>
  );
}
