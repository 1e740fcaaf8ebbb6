// Choices kept in this browser. Where storage is forbidden they last as long as the page.
export function kept(name: string): string | null {
  try {
    return localStorage.getItem(`marketgen.${name}`);
  } catch {
    return null;
  }
}

export function keep(name: string, value: string): void {
  try {
    localStorage.setItem(`marketgen.${name}`, value);
  } catch {
    // Not allowed: nothing is lost but the choice.
  }
}
