/** A column of a table, with the SI unit of its numbers. */
export interface UnitColumn {
  name: string;
  unit: string;
  data: Float64Array;
}

/**
 * Writes columns as a compressed Parquet file; its metadata holds `about`, as in results of the Python package, and the
 * units.
 */
export async function parquetOf(columns: readonly UnitColumn[], about: Record<string, string>): Promise<ArrayBuffer> {
  const { parquetWriteBuffer } = await import("hyparquet-writer");
  const units = JSON.stringify(Object.fromEntries(columns.map(({ name, unit }) => [name, unit])));
  return parquetWriteBuffer({
    columnData: columns.map(({ name, data }) => ({ name, data, type: "DOUBLE" as const, nullable: false })),
    kvMetadata: Object.entries({ ...about, units }).map(([key, value]) => ({ key, value })),
    createdBy: "Kingpost",
  });
}
