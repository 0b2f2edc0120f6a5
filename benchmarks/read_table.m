% Reads a signature table of MATLAB's layout and the same table as CSV, and says how far their
% contrast intensities are apart: GNU Octave is a reader that has nothing of ours.
%
%     smat-batch table PROJECT --band 3-5,8-12 ... --out table.mat
%     smat-batch table PROJECT --band 3-5,8-12 ... --out table.csv
%     octave-cli benchmarks/read_table.m table.mat table.csv
%
% Of tables over azimuth, elevation and bands. Ends with 1 where a cell is off by more than 1e-12.

files = argv();
s = load(files{1});
value = s.Sign .* 10 .^ (s.Pattern / 10); % W/sr
lines = strsplit(fileread(files{2}), "\n");
lines = lines(~cellfun(@(line) isempty(line) || line(1) == '#', lines));
head = strsplit(lines{1}, ',');
azimuth = find(strncmp(head, 'azimuth', 7));
elevation = find(strncmp(head, 'elevation', 9));
bands = find(strncmp(head, 'contrast_intensity', 18));
worst = 0;
cells = 0;
for i = 2:numel(lines)
    row = str2double(strsplit(lines{i}, ','));
    angle = row(azimuth) - 360 * (row(azimuth) > 180);
    y = find(abs(s.Elevation - row(elevation)) < 1e-9);
    x = find(abs(s.Azimuth - angle) < 1e-9);
    for b = 1:numel(bands)
        truth = row(bands(b));
        worst = max(worst, abs(value(y, x, b) - truth) / max(abs(truth), eps));
        cells++;
    end
end
printf('%d cells, largest relative difference %.1e\n', cells, worst);
if worst > 1e-12
    exit(1);
end
